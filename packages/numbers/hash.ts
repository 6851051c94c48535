/** A 64-bit hash as two whole numbers 0..2^32−1: upper and lower half. Changed in place by `addToHash`. */
export type Hash = [number, number]

const double = new Float64Array(1)
const words = new Int32Array(double.buffer)
const LOW = new Uint8Array(new Uint16Array([1]).buffer)[0] === 1 ? 0 : 1
const HIGH = 1 - LOW

/** The hash of nothing. */
export function startHash(): Hash {
  return [0xcbf29ce4, 0x84222325]
}

/**
 * Adds the 8 bytes of a double, lowest first: FNV-1a 64 (RFC 9923). −0 counts as 0 (nobody can see the difference in
 * a pose), and every NaN as the same one (engines differ in its bits).
 */
export function addToHash(hash: Hash, x: number): void {
  if (x === x) double[0] = x + 0
  else setNaN()
  addWord(hash, words[LOW]!)
  addWord(hash, words[HIGH]!)
}

/** 16 hexadecimal digits, lower case. */
export function hex(hash: readonly [number, number]): string {
  return hash.map((half) => half.toString(16).padStart(8, '0')).join('')
}

function setNaN(): void {
  words[LOW] = 0
  words[HIGH] = 0x7ff80000
}

/** Four rounds of (hash ^ byte) · (2^40 + 0x1b3), the lower half in pieces of 16 bits so that 32 bits hold every product. */
function addWord(hash: Hash, word: number): void {
  let high = hash[0] | 0
  let low = hash[1] | 0
  for (let shift = 0; shift < 32; shift += 8) {
    low ^= (word >>> shift) & 0xff
    const lower = (low & 0xffff) * 0x1b3
    const upper = (low >>> 16) * 0x1b3 + (lower >>> 16)
    high = (Math.imul(high, 0x1b3) + (low << 8) + (upper >>> 16)) | 0
    low = (lower & 0xffff) | (upper << 16)
  }
  hash[0] = high >>> 0
  hash[1] = low >>> 0
}
