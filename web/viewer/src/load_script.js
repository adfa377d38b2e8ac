// Data come as scripts that call sabo_scene or sabo_frame: pages opened from disk may load nothing
// else.

const waiting = new Map();

function receive(value) {
  waiting.get(document.currentScript)?.(value);
}
window.sabo_scene = receive;
window.sabo_frame = receive;

/** What the script at `url` hands over. */
export function loadScript(url) {
  return new Promise((resolve, reject) => {
    const script = document.createElement('script');
    const end = (settle) => {
      waiting.delete(script);
      script.remove();
      settle();
    };
    let value;
    waiting.set(script, (given) => { value = given; });
    script.onload = () => end(() => (value ? resolve(value) : reject(new Error(url))));
    script.onerror = () => end(() => reject(new Error(url)));
    script.src = url;
    document.head.append(script);
  });
}

/** Bytes of a text in base64. */
export function bytesOf(text) {
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text);
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; ++i) bytes[i] = binary.charCodeAt(i);
  return bytes;
}
