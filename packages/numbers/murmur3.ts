// MurmurHash3_x86_128 with seed 0, Austin Appleby 2011 (public domain):
// https://github.com/aappleby/smhasher/wiki/MurmurHash3

const FACTORS = [0x239b961b, 0xab0e9789, 0x38b34ae5, 0xa1e38b93] as const
const TURNS = [15, 16, 17, 18] as const
const LANE_TURNS = [19, 17, 15, 13] as const
const OFFSETS = [0x561ccd1b, 0x0bcaa747, 0x96cd1c35, 0x32ac3b17] as const

type Words = [number, number, number, number]

/** 128 bits of hash as four whole numbers 0..2^32−1. */
export function murmur3(bytes: Uint8Array): Words {
  const lanes: Words = [0, 0, 0, 0]
  const whole = bytes.length - (bytes.length % 16)
  for (let at = 0; at < whole; at += 16) addBlock(lanes, bytes, at)
  for (let lane = 3; lane >= 0; lane--) {
    const k = word(bytes, whole + lane * 4)
    if (k !== 0) lanes[lane] = lanes[lane]! ^ scramble(k, lane)
  }
  return finish(lanes, bytes.length)
}

function addBlock(lanes: Words, bytes: Uint8Array, at: number): void {
  for (let lane = 0; lane < 4; lane++) {
    const mixed = turn(lanes[lane]! ^ scramble(word(bytes, at + lane * 4), lane), LANE_TURNS[lane]!)
    lanes[lane] = (Math.imul(mixed + lanes[(lane + 1) % 4]!, 5) + OFFSETS[lane]!) | 0
  }
}

function scramble(k: number, lane: number): number {
  return Math.imul(turn(Math.imul(k, FACTORS[lane]!), TURNS[lane]!), FACTORS[(lane + 1) % 4]!)
}

function finish(lanes: Words, length: number): Words {
  for (let lane = 0; lane < 4; lane++) lanes[lane] = lanes[lane]! ^ length
  gather(lanes)
  for (let lane = 0; lane < 4; lane++) lanes[lane] = avalanche(lanes[lane]!)
  gather(lanes)
  return lanes.map((lane) => lane >>> 0) as Words
}

function gather(lanes: Words): void {
  lanes[0] = (lanes[0] + lanes[1] + lanes[2] + lanes[3]) | 0
  for (let lane = 1; lane < 4; lane++) lanes[lane] = (lanes[lane]! + lanes[0]) | 0
}

function avalanche(h: number): number {
  const first = Math.imul(h ^ (h >>> 16), 0x85ebca6b)
  const second = Math.imul(first ^ (first >>> 13), 0xc2b2ae35)
  return second ^ (second >>> 16)
}

/** Little endian; bytes after the end are 0. */
function word(bytes: Uint8Array, at: number): number {
  const byte = (index: number) => bytes[at + index] ?? 0
  return byte(0) | (byte(1) << 8) | (byte(2) << 16) | (byte(3) << 24)
}

function turn(x: number, by: number): number {
  return (x << by) | (x >>> (32 - by))
}
