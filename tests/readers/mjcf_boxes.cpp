// Prints the boxes of a MuJoCo .xml file as MuJoCo compiles them.

#include "print_box.hpp"

#include <mujoco/mujoco.h>

int main(int, char** arguments) {
  char error[1000] = "";
  const mjModel* model = mj_loadXML(arguments[1], nullptr, error, sizeof(error));
  if (model == nullptr) {
    std::fprintf(stderr, "%s\n", error);
    return 1;
  }
  for (int i = 0; i < model->ngeom; ++i) {
    if (model->geom_type[i] != mjGEOM_BOX) return 1;
    const mjtNum* center = model->geom_pos + 3 * i;
    const mjtNum* turn = model->geom_quat + 4 * i;
    const mjtNum* half = model->geom_size + 3 * i;
    print_box({center[0], center[1], center[2]}, {turn[1], turn[2], turn[3], turn[0]},
              {2 * half[0], 2 * half[1], 2 * half[2]});
  }
}
