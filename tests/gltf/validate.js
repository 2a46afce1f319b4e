// Exports a preset as .glb and shows it to Khronos' validator: no error and no warning.
//   node validate.js FROND VALIDATOR_FOLDER PRESET [--set POINTER=VALUE]...
'use strict';
const {execFileSync} = require('child_process');
const fs = require('fs');
const os = require('os');
const path = require('path');

async function main([frond, folder, preset, ...sets]) {
  const validator = require(path.resolve(folder, 'node_modules/gltf-validator'));
  const scratch = fs.mkdtempSync(path.join(os.tmpdir(), 'frond_gltf_'));
  try {
    const file = path.join(scratch, 'scene.glb');
    execFileSync(frond, ['export', preset, '-q', '-o', file, ...sets], {stdio: 'inherit'});
    const report = await validator.validateBytes(new Uint8Array(fs.readFileSync(file)), {maxIssues: 20});
    const {numErrors, numWarnings, messages} = report.issues;
    for (const m of messages) if (m.severity < 2) console.log(`${m.code} ${m.pointer}: ${m.message}`);
    console.log(`${preset}: ${numErrors} errors, ${numWarnings} warnings, ${report.info.totalTriangleCount} triangles`);
    return numErrors + numWarnings === 0 ? 0 : 1;
  } finally {
    fs.rmSync(scratch, {recursive: true});
  }
}

main(process.argv.slice(2)).then(code => process.exitCode = code);
