import type { Course } from '@botgarten/learning/q-learning'

/** Longest step of the clock, ms: after the page was hidden it does not catch up. */
const LONGEST = 250

/** Milliseconds of a frame that learning may take in turbo. The rest is for drawing: after a late frame there is more of it. */
export const budgetFor = (passed: number): number => (passed > 20 ? 4 : 7)

/** Calls once a frame while it runs, with the milliseconds that have passed. */
export class Clock {
  readonly #turn: (passed: number, now: number) => void
  #frame = 0
  #before = 0

  constructor(turn: (passed: number, now: number) => void) {
    this.#turn = turn
  }

  start(): void {
    this.#before = performance.now()
    if (this.#frame === 0) this.#frame = requestAnimationFrame(this.#tick)
  }

  stop(): void {
    cancelAnimationFrame(this.#frame)
    this.#frame = 0
  }

  #tick = (now: number): void => {
    this.#frame = requestAnimationFrame(this.#tick)
    const passed = Math.min(LONGEST, Math.max(0, now - this.#before))
    this.#before = now
    this.#turn(passed, now)
  }
}

/** Resolves in the task after the next frame has been drawn. */
export const nextFrame = (): Promise<unknown> =>
  new Promise((done) => requestAnimationFrame(() => setTimeout(done)))

/** Calls `act` at most once in `ms`; the returned function is called in every frame with its time. */
export function atMostEvery(ms: number, act: () => void): (now: number) => void {
  let last = 0
  return (now) => {
    if (now - last < ms) return
    last = now
    act()
  }
}

/** Repeats a course up to a move, in slices between frames. Returns false as soon as `isWanted` is false. */
export async function replay(course: Course, moves: number, isWanted: () => boolean): Promise<boolean> {
  while (course.made < moves && !course.over) {
    course.advance(Math.min(20_000, moves - course.made))
    await new Promise(requestAnimationFrame)
    if (!isWanted()) return false
  }
  return true
}

/** Calls `pause` when the page is hidden or Escape is pressed. Returns the function that ends this. */
export function pauseWhenAway(pause: () => void): () => void {
  const away = () => document.hidden && pause()
  const escape = ({ key }: KeyboardEvent) => key === 'Escape' && pause()
  document.addEventListener('visibilitychange', away)
  window.addEventListener('keydown', escape)
  return () => {
    document.removeEventListener('visibilitychange', away)
    window.removeEventListener('keydown', escape)
  }
}

/**
 * Pauses endless animations outside the playground, such as those of the mascots: they distract, and cost time in every
 * frame. Returns the function that resumes them.
 */
export function holdStill(playground: Element): () => void {
  const held = document.getAnimations().filter(({ effect }) => {
    const target = effect instanceof KeyframeEffect ? effect.target : null
    return target && effect?.getTiming().iterations === Infinity && !playground.contains(target)
  })
  for (const one of held) one.pause()
  return () => {
    for (const one of held) if (one.playState === 'paused') one.play()
  }
}

/** Shows the latest value in the next frame, and no other in the frame after it, in which the words are updated. */
export function onNextFrame(show: (value: number) => void): (value: number) => void {
  let wanted: number | null = null
  let waiting = false

  function go() {
    waiting = wanted !== null
    if (wanted === null) return
    show(wanted)
    wanted = null
    requestAnimationFrame(() => requestAnimationFrame(go))
  }

  return (value) => {
    wanted = value
    if (!waiting) requestAnimationFrame(go)
    waiting = true
  }
}
