// Prints what Khronos' glTF validator finds in GLB files; fails on errors and warnings.
// node validate_glb.js MODULE_FOLDER FILE...
const fs = require('fs');
const path = require('path');
const validator = require(path.resolve(process.argv[2], 'gltf-validator'));

(async () => {
    let bad = 0;
    for (const file of process.argv.slice(3)) {
        const { issues } = await validator.validateBytes(new Uint8Array(fs.readFileSync(file)));
        console.log(`${path.basename(file)}: ${issues.numErrors} errors, ${issues.numWarnings} warnings`);
        for (const message of issues.messages.filter((one) => one.severity < 2)) console.log(`  ${message.pointer}: ${message.message}`);
        bad += issues.numErrors + issues.numWarnings;
    }
    process.exit(bad === 0 ? 0 : 1);
})();
