// Prints the triangles of a mesh as assimp reads them, in the frame of the whole file.

#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <cstdio>

int main(int, char** arguments) {
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(arguments[1], aiProcess_PreTransformVertices);
  if (scene == nullptr) {
    std::fprintf(stderr, "%s\n", importer.GetErrorString());
    return 1;
  }
  for (unsigned m = 0; m < scene->mNumMeshes; ++m) {
    const aiMesh& mesh = *scene->mMeshes[m];
    if (!mesh.HasVertexColors(0)) return 1;
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      std::printf("triangle");
      for (unsigned k = 0; k < 3; ++k) {
        const aiVector3D& at = mesh.mVertices[mesh.mFaces[f].mIndices[k]];
        std::printf(" %.9g %.9g %.9g", at.x, at.y, at.z);
      }
      std::printf("\n");
    }
  }
}
