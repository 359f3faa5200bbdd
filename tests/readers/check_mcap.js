// Prints how many messages @mcap/core finds in an MCAP file, with all checksums verified; fails when
// it refuses the file or the count is not the second argument.

const fs = require('fs');
const {McapStreamReader} = require('@mcap/core');
const {loadDecompressHandlers} = require('@mcap/support');

async function main() {
  const reader = new McapStreamReader({
    validateCrcs: true,
    decompressHandlers: await loadDecompressHandlers(),
  });
  reader.append(fs.readFileSync(process.argv[2]));
  let messages = 0;
  for (let record; (record = reader.nextRecord());) {
    if (record.type === 'Message') ++messages;
  }
  console.log(`${messages} messages`);
  if (!reader.done()) throw new Error('the file does not end as it should');
  if (messages !== Number(process.argv[3])) throw new Error(`expected ${process.argv[3]}`);
}

main().catch((error) => {
  console.log(error.message);
  process.exit(1);
});
