/** Milliseconds of a frame that work in slices takes at most. */
const BUDGET = 4

/**
 * Does work in slices, a few milliseconds a frame, so that nothing on the screen waits for it. Returns how to give it up.
 * `done` gets the result, not before the next frame.
 */
export function inSlices<Result>(
  work: Generator<undefined, Result>,
  done: (result: Result) => void,
): () => void {
  let frame = requestAnimationFrame(go)
  function go() {
    const end = performance.now() + BUDGET
    do {
      const step = work.next()
      if (step.done) return done(step.value)
    } while (performance.now() < end)
    frame = requestAnimationFrame(go)
  }
  return () => cancelAnimationFrame(frame)
}
