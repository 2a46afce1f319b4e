// Exports the last frame of a preset as .glb and shows it to Khronos' validator: no error and no warning.
//   node validate.js FROND VALIDATOR_FOLDER PRESET [--set POINTER=VALUE]... [-- OPTION_OF_EXPORT...]
'use strict';
const {execFileSync} = require('child_process');
const fs = require('fs');
const os = require('os');
const path = require('path');

async function main([frond, folder, preset, ...given]) {
  const end = given.indexOf('--') < 0 ? given.length : given.indexOf('--');
  const [sets, options] = [given.slice(0, end), given.slice(end + 1)];
  const validator = require(path.resolve(folder, 'node_modules/gltf-validator'));
  const scratch = fs.mkdtempSync(path.join(os.tmpdir(), 'frond_gltf_'));
  try {
    const file = path.join(scratch, 'scene.glb');
    // Small pictures: drawing large ones takes longer than all else, and their size is nothing to the validator.
    const words = ['export', preset, '--texture', '64', '-q', '-o', file, ...sets, ...options];
    execFileSync(frond, words, {stdio: 'inherit'});
    // It stops at a limit of issues, so there is none; places on textures may be there without a texture, and tangents
    // are made by who reads the file, in the way that glTF prescribes.
    const heeded = {maxIssues: 0, ignoredIssues: ['UNUSED_OBJECT', 'MESH_PRIMITIVE_GENERATED_TANGENT_SPACE']};
    const report = await validator.validateBytes(new Uint8Array(fs.readFileSync(file)), heeded);
    const {numErrors, numWarnings, messages} = report.issues;
    const faults = messages.filter(m => m.severity < 2).slice(0, 20);
    for (const m of faults) console.log(`${m.code} ${m.pointer}: ${m.message}`);
    if (!report.info) throw new Error(`${preset}: not read whole: ${JSON.stringify(report)}`);
    console.log(`${preset}: ${numErrors} errors, ${numWarnings} warnings, ${report.info.totalTriangleCount} triangles`);
    return numErrors + numWarnings === 0 ? 0 : 1;
  } finally {
    fs.rmSync(scratch, {recursive: true});
  }
}

main(process.argv.slice(2)).then(code => process.exitCode = code);
