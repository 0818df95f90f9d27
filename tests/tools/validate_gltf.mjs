// Checks GLB files with Khronos' validator: node tests/tools/validate_gltf.mjs FILE...
// Prints one line of JSON: {"FILE": {"errors": 0, "warnings": 0, "messages": [...]}}; exit code 1 on any error or warning.
import { readFile } from "node:fs/promises";
import validator from "gltf-validator";

const results = {};
for (const file of process.argv.slice(2)) {
  const { issues } = await validator.validateBytes(new Uint8Array(await readFile(file)), { uri: file });
  results[file] = {
    errors: issues.numErrors,
    warnings: issues.numWarnings,
    infos: issues.numInfos,
    messages: issues.messages.slice(0, 20).map((m) => `${m.code} at ${m.pointer}: ${m.message}`),
  };
}
console.log(JSON.stringify(results));
process.exitCode = Object.values(results).some((r) => r.errors + r.warnings > 0) ? 1 : 0;
