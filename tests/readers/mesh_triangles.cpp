// Prints the triangles of a mesh as assimp reads them, in the frame of the whole file. Its nodes
// are applied in double: assimp's own transform rounds each product to float.

#include <assimp/Importer.hpp>
#include <assimp/scene.h>
#include <cstdio>

namespace {

using Matrix = aiMatrix4x4t<double>;

bool print_node(const aiScene& scene, const aiNode& node, const Matrix& file_from_parent) {
  const Matrix file_from_node = file_from_parent * Matrix(node.mTransformation);
  for (unsigned m = 0; m < node.mNumMeshes; ++m) {
    const aiMesh& mesh = *scene.mMeshes[node.mMeshes[m]];
    if (!mesh.HasVertexColors(0)) return false;
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      std::printf("triangle");
      for (unsigned k = 0; k < 3; ++k) {
        const aiVector3D& vertex = mesh.mVertices[mesh.mFaces[f].mIndices[k]];
        const auto at = file_from_node * aiVector3t<double>(vertex.x, vertex.y, vertex.z);
        std::printf(" %.17g %.17g %.17g", at.x, at.y, at.z);
      }
      std::printf("\n");
    }
  }
  for (unsigned i = 0; i < node.mNumChildren; ++i) {
    if (!print_node(scene, *node.mChildren[i], file_from_node)) return false;
  }
  return true;
}

}  // namespace

int main(int, char** arguments) {
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(arguments[1], 0);
  if (scene == nullptr) {
    std::fprintf(stderr, "%s\n", importer.GetErrorString());
    return 1;
  }
  return print_node(*scene, *scene->mRootNode, Matrix()) ? 0 : 1;
}
