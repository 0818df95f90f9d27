/** Bundle the viewer into the Python package: `npm run build` here, or `make page` at the top of the repository. */
import { createHash } from "node:crypto";
import { readdir, readFile, writeFile } from "node:fs/promises";
import { build } from "esbuild";

const here = new URL("./", import.meta.url);
const target = new URL("../src/robolayout/page/data/", here);
const three = JSON.parse(await readFile(new URL("node_modules/three/package.json", here), "utf8")).version;

/** Return a fingerprint of everything that the bundle is made from, so that a stale bundle is found without Node. */
async function fingerprint() {
  const hash = createHash("sha256");
  const sources = (await readdir(new URL("src/", here))).sort().map((name) => `src/${name}`);
  for (const name of ["package.json", "build.mjs", ...sources]) {
    const text = await readFile(new URL(name, here), "utf8");
    hash.update(`${name}\n${text.replaceAll("\r\n", "\n")}\n`);
  }
  return hash.digest("hex");
}

const licence = await readFile(new URL("node_modules/three/LICENSE", here), "utf8");
const banner = `/* The viewer of report.html, made by web/build.mjs; do not edit.
sources ${await fingerprint()}
It contains three.js ${three}:

${licence.replaceAll("\u00a9", "(c)").trim()}
*/`;

const options = { bundle: true, minify: true, charset: "ascii", logLevel: "warning", write: false, absWorkingDir: new URL(".", here).pathname };
const script = await build({ ...options, entryPoints: ["src/main.js"], format: "iife", target: "es2022", legalComments: "inline" });
const style = await build({ ...options, entryPoints: ["src/viewer.css"] });

await writeFile(new URL("viewer.js", target), `${banner}\n${script.outputFiles[0].text}`);
await writeFile(new URL("viewer.css", target), style.outputFiles[0].text);
await writeFile(new URL("page.html", target), await readFile(new URL("src/page.html", here), "utf8"));
