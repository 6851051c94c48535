// Functions of JavaScript and of the web that the oldest promised browsers (promised.ts) do not have. Tests
// compare their results with those of the same functions in Node.

/**
 * `Map.groupBy` (Safari 17.4, Firefox 119, Chrome 117): items by key, in the order in which the keys first occur.
 * @param keyOf called once for each item
 */
export function groupBy<Item, Key>(
  items: Iterable<Item>,
  keyOf: (item: Item, index: number) => Key,
): Map<Key, Item[]> {
  const groups = new Map<Key, Item[]>()
  let index = 0
  for (const item of items) {
    const key = keyOf(item, index++)
    const group = groups.get(key)
    if (group) group.push(item)
    else groups.set(key, [item])
  }
  return groups
}

/** Arguments of one call that every engine accepts. */
const atOnce = 0x8000

/** `Uint8Array.prototype.toBase64` (Safari 18.2, Firefox 133, Chrome 140). */
export function toBase64(bytes: Uint8Array): string {
  let text = ''
  for (let from = 0; from < bytes.length; from += atOnce)
    text += String.fromCharCode(...bytes.subarray(from, from + atOnce))
  return btoa(text)
}

/**
 * `Uint8Array.fromBase64` (Safari 18.2, Firefox 133, Chrome 140).
 * @throws DOMException if the text is no base64
 */
export const fromBase64 = (text: string): Uint8Array<ArrayBuffer> =>
  Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0))

/** `URL.parse` (Safari 18, Firefox and Chrome 126): null if the text is no address. */
export function parseUrl(text: string): URL | null {
  try {
    return new URL(text)
  } catch {
    return null
  }
}
