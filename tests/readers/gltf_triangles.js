// Prints the triangles of a .glb file as glTF-Transform reads them, in the frame of the whole file:
// numbers of nodes stay doubles there.

const { NodeIO } = require('@gltf-transform/core');

// Matrices are column by column.
function placed(matrix, [x, y, z]) {
  return [0, 1, 2].map((row) =>
    matrix[row] * x + matrix[4 + row] * y + matrix[8 + row] * z + matrix[12 + row]);
}

new NodeIO().read(process.argv[2]).then((document) => {
  for (const node of document.getRoot().listNodes()) {
    const matrix = node.getWorldMatrix();
    for (const primitive of node.getMesh()?.listPrimitives() ?? []) {
      const positions = primitive.getAttribute('POSITION');
      const indices = primitive.getIndices().getArray();
      for (let first = 0; first < indices.length; first += 3) {
        const corners = [...indices.slice(first, first + 3)].map((index) =>
          placed(matrix, positions.getElement(index, [])).join(' '));
        console.log(`triangle ${corners.join(' ')}`);
      }
    }
  }
});
