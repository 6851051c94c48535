/** One frame of a screen in milliseconds. */
const frame = 1000 / 60

/**
 * Lets a value that comes every frame through every `frames`-th time only. The beat is common to all: what is drawn
 * every fourth frame is drawn together with what is drawn every second one. What is not `live` passes at once.
 */
export function calm(frames: number): (now: number, live: boolean) => boolean {
  let last = -1
  return (now, live) => {
    const beat = Math.floor(now / (frames * frame))
    if (live && beat === last) return false
    last = beat
    return true
  }
}
