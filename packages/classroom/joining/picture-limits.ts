/** Wrong tries on a pupil's own device before it has to wait. */
const free = 3
const firstPause = 60_000

/**
 * Ms for which a pupil's own device waits after a number of wrong tries: a minute after the third, and twice as long after
 * each further one. So at most 11 of 1,320 sets of pictures are tried within a school day of 8 hours.
 */
export const pauseAfter = (wrong: number): number => (wrong < free ? 0 : firstPause * 2 ** (wrong - free))

/** Wrong tries at a nickname from devices that are not its own, and how many more after the teacher has opened the locks. */
const [first, more] = [5, 2]
/** Together with the 11 of an own device 26 of 1,320: less than 2 %. */
const most = 15

/** How many wrong tries at a nickname other devices have, by how often the teacher has opened the locks. */
export const triesAfter = (openings: number): number => Math.min(most, first + more * openings)

/** How often opening the locks gives new tries. */
export const mostOpenings = (most - first) / more
