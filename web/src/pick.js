/** Which asset is under the pointer. */
import { Raycaster, Vector2 } from "three";

const STILL = 6;

/** Call `choose` with the index of an asset that is clicked (null: nothing), and show a hand over assets. */
export function makePicking(stage, assets, canvas, choose) {
  const ray = new Raycaster();
  const present = assets.filter(Boolean);
  const under = (event) => {
    const { left, top, width, height } = canvas.getBoundingClientRect();
    const at = new Vector2(((event.clientX - left) / width) * 2 - 1, 1 - ((event.clientY - top) / height) * 2);
    ray.setFromCamera(at, stage.camera);
    const hit = ray.intersectObjects(present, true)[0];
    if (!hit) return null;
    let node = hit.object;
    while (!present.includes(node)) node = node.parent;
    return assets.indexOf(node);
  };
  let pressed = null;
  let waiting = false;
  canvas.addEventListener("pointerdown", (event) => (pressed = [event.clientX, event.clientY]));
  canvas.addEventListener("pointerup", (event) => {
    if (pressed && Math.hypot(event.clientX - pressed[0], event.clientY - pressed[1]) < STILL) choose(under(event));
    pressed = null;
  });
  canvas.addEventListener("pointermove", (event) => {
    if (waiting || event.buttons) return;
    waiting = true;
    requestAnimationFrame(() => {
      waiting = false;
      canvas.classList.toggle("over", under(event) !== null);
    });
  });
}
