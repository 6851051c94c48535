import { murmur3 } from './murmur3.ts'

/** A random stream's whole state: four whole numbers 0..2^32−1. A copy of it goes on with the same draws. */
export type StreamState = [number, number, number, number]

/**
 * Starts the stream `name` of a run with this seed (any number). Streams of different names or seeds are independent,
 * so that a new one changes no old run. State = MurmurHash3_x86_128 of the seed's 8 bytes (little endian) and the
 * name in UTF-8.
 */
export function stream(seed: number, name: string): StreamState {
  const text = new TextEncoder().encode(name)
  const bytes = new Uint8Array(8 + text.length)
  new DataView(bytes.buffer).setFloat64(0, seed, true)
  bytes.set(text, 8)
  const state = murmur3(bytes)
  // The one state from which the generator never moves.
  return state.some((word) => word !== 0) ? state : [1, 0, 0, 0]
}

/** The next number of a stream, uniform in [0, 1), 53 bits: two outputs of xoshiro128** joined as in mt19937ar.c. */
export function draw(state: StreamState): number {
  const upper = next(state) >>> 5
  const lower = next(state) >>> 6
  return (upper * 67108864 + lower) / 9007199254740992
}

/** xoshiro128** 1.1, Blackman & Vigna 2018: https://prng.di.unimi.it/xoshiro128starstar.c. 32 bits, signed. */
function next(state: StreamState): number {
  const a = state[0]
  const b = state[1]
  const c = state[2] ^ a
  const d = state[3] ^ b
  const times5 = Math.imul(b, 5)
  const result = Math.imul((times5 << 7) | (times5 >>> 25), 9)
  state[0] = (a ^ d) >>> 0
  state[1] = (b ^ c) >>> 0
  state[2] = (c ^ (b << 9)) >>> 0
  state[3] = ((d << 11) | (d >>> 21)) >>> 0
  return result
}

/** A stream for millions of draws a second: the words of a `StreamState` without its boxes. */
export type FastStream = Uint32Array

/** A fast stream that goes on where `state` stands. */
export const fastStream = (state: readonly number[]): FastStream => Uint32Array.from(state)

/** The next number of a fast stream, uniform in [0, 1), 32 bits: one output of xoshiro128**. */
export function fastDraw(state: FastStream): number {
  const a = state[0]!
  const b = state[1]!
  const c = state[2]! ^ a
  const d = state[3]! ^ b
  const times5 = Math.imul(b, 5)
  const result = Math.imul((times5 << 7) | (times5 >>> 25), 9)
  state[0] = a ^ d
  state[1] = b ^ c
  state[2] = c ^ (b << 9)
  state[3] = (d << 11) | (d >>> 21)
  return (result >>> 0) / 4294967296
}
