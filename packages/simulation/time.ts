/** Ticks of simulated time in a second (running.md 2). */
export const TICKS_PER_SECOND = 60

/** Physics is built again from the plain state this often (running.md 8). */
export const KEYFRAME_EVERY = 300
