// Validates glTF files; prints a line of JSON each: name, errors, warnings, messages.
const fs = require("fs"), path = require("path");
const validator = require("gltf-validator");
(async () => {
  for (const file of process.argv.slice(2)) {
    const report = await validator.validateBytes(new Uint8Array(fs.readFileSync(file)), { uri: path.basename(file) });
    const { numErrors, numWarnings, numInfos, messages } = report.issues;
    console.log(JSON.stringify({ file: path.basename(file), numErrors, numWarnings, numInfos, messages: messages.slice(0, 3), info: report.info }));
  }
})();
