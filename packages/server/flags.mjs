/** How Node runs a server: a laptop in a classroom has other uses for its memory. */
export const serverFlags = ['--max-semi-space-size=2', '--optimize-for-size']

/** The allocator of Linux is not to keep a store of memory for each thread. */
export const serverEnv = { MALLOC_ARENA_MAX: '2' }
