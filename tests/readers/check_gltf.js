// Prints what the validator of Khronos finds in a .glb file; fails when that is an error or a warning.

const fs = require('fs');
const validator = require('gltf-validator');

validator.validateBytes(new Uint8Array(fs.readFileSync(process.argv[2]))).then((report) => {
  for (const message of report.issues.messages) console.error(message.code, message.message);
  process.exit(report.issues.numErrors + report.issues.numWarnings);
});
