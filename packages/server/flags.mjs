import { fileURLToPath } from 'node:url'

/** How Node runs a server: a laptop in a classroom has other uses for its memory. */
export const serverFlags = ['--max-semi-space-size=2', '--optimize-for-size']

const cache = new URL('../../node_modules/.cache/node', import.meta.url)

export const serverEnv = {
  /** The allocator of Linux is not to keep a store of memory for each thread. */
  MALLOC_ARENA_MAX: '2',
  /** What a large save took goes back to the system at once. Left alone, the limit rises with the first that is freed. */
  MALLOC_MMAP_THRESHOLD_: '131072',
  /** From the second start on Node strips no types any more, and does without the 24 MB of what strips them. */
  NODE_COMPILE_CACHE: process.env['NODE_COMPILE_CACHE'] ?? fileURLToPath(cache),
}
