const FIRST_PRIMES = [2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47, 53, 59, 61, 67, 71, 73, 79, 83, 89, 97, 101, 103, 107, 109, 113, 127, 131, 137, 139, 149, 151, 157, 163, 167, 173, 179, 181, 191, 193, 197, 199, 211, 223, 227, 229, 233, 239, 241, 251, 257, 263, 269, 271, 277, 281, 283, 293, 307, 311] // prettier-ignore

/** The first 32 bits behind the point of the root of a prime: floor(root · 2^32) mod 2^32, worked out in whole numbers. */
function fraction(prime: number, degree: 2 | 3): number {
  const wanted = BigInt(prime) << BigInt(32 * degree)
  let low = 0n
  let high = 1n << 40n
  while (high - low > 1n) {
    const middle = (low + high) / 2n
    if (middle * middle * (degree === 3 ? middle : 1n) <= wanted) low = middle
    else high = middle
  }
  return Number(low & 0xffffffffn) | 0
}

const ROUND = Int32Array.from(FIRST_PRIMES, (prime) => fraction(prime, 3))
const START = FIRST_PRIMES.slice(0, 8).map((prime) => fraction(prime, 2))

/**
 * SHA-256 (FIPS 180-4) as 64 hexadecimal digits: the name of a picture in a project. Browsers give theirs only to pages
 * that came over https or from this machine.
 */
export function sha256(bytes: Uint8Array): string {
  const state = Int32Array.from(START)
  const words = new Int32Array(64)
  const padded = pad(bytes)
  const view = new DataView(padded.buffer)
  for (let at = 0; at < padded.length; at += 64) {
    for (let index = 0; index < 16; index++) words[index] = view.getInt32(at + index * 4)
    spread(words)
    compress(state, words)
  }
  return Array.from(state, (word) => (word >>> 0).toString(16).padStart(8, '0')).join('')
}

/** A one, zeros, and the length in bits, up to whole blocks of 64 bytes. */
function pad(bytes: Uint8Array): Uint8Array<ArrayBuffer> {
  const padded = new Uint8Array(Math.ceil((bytes.length + 9) / 64) * 64)
  padded.set(bytes)
  padded[bytes.length] = 0x80
  const view = new DataView(padded.buffer)
  view.setUint32(padded.length - 8, Math.floor(bytes.length / 0x20000000))
  view.setUint32(padded.length - 4, (bytes.length * 8) >>> 0)
  return padded
}

const turned = (word: number, by: number) => (word >>> by) | (word << (32 - by))

function spread(words: Int32Array): void {
  for (let index = 16; index < 64; index++) {
    const [a, b] = [words[index - 15]!, words[index - 2]!]
    const lower = turned(a, 7) ^ turned(a, 18) ^ (a >>> 3)
    const upper = turned(b, 17) ^ turned(b, 19) ^ (b >>> 10)
    words[index] = words[index - 16]! + lower + words[index - 7]! + upper
  }
}

function compress(state: Int32Array, words: Int32Array): void {
  let [a, b, c, d, e, f, g, h] = state as unknown as [number, number, number, number, number, number, number, number] // prettier-ignore
  for (let round = 0; round < 64; round++) {
    const upper = turned(e, 6) ^ turned(e, 11) ^ turned(e, 25)
    const first = (h + upper + ((e & f) ^ (~e & g)) + ROUND[round]! + words[round]!) | 0
    const lower = turned(a, 2) ^ turned(a, 13) ^ turned(a, 22)
    const second = (lower + ((a & b) ^ (a & c) ^ (b & c))) | 0
    ;[h, g, f, e, d, c, b, a] = [g, f, e, (d + first) | 0, c, b, a, (first + second) | 0]
  }
  ;[a, b, c, d, e, f, g, h].forEach((word, index) => (state[index]! += word))
}
