// Runs inside the page: nothing from outside a function is there.

declare global {
  var frameTimes: number[]
  var answer: Promise<number>
}

/** Notes the time of every frame from now on; what was noted before is forgotten. */
export function noteFrames() {
  const notes = 'frameTimes' in globalThis
  globalThis.frameTimes = []
  if (notes) return
  const note = (time: number) => {
    globalThis.frameTimes.push(time)
    requestAnimationFrame(note)
  }
  requestAnimationFrame(note)
}

/** What was last asked for, when it has come. */
export const answered = () => globalThis.answer

/** Asks for the frames between the next pointer movement and the next change inside `changing`. */
export function askFramesUntilChange(changing: Element) {
  globalThis.answer = new Promise<number>((done) => {
    const now = () => globalThis.frameTimes.length
    let from = Infinity
    addEventListener('pointermove', () => (from = now()), { capture: true, once: true })
    const watcher = new MutationObserver(() => {
      if (from === Infinity) return
      watcher.disconnect()
      done(now() - from)
    })
    watcher.observe(changing, { subtree: true, characterData: true, childList: true, attributes: true })
  })
}

/** Asks for the milliseconds from the next click, as the browser stamps it, to the first frame that shows the robot elsewhere. */
export function askMillisecondsToMove(robot: Element) {
  globalThis.answer = new Promise<number>((done) => {
    // Released builds before it was painted moved the robot's handle.
    const place = () =>
      JSON.stringify(globalThis.botgarten?.view()?.robots[0]?.pose) ?? robot.parentElement!.style.transform
    const before = place()
    const begin = ({ timeStamp }: MouseEvent) => {
      const look = () => {
        if (place() === before) requestAnimationFrame(look)
        else done(performance.now() - timeStamp)
      }
      look()
    }
    addEventListener('click', begin, { capture: true, once: true })
  })
}
