// Runs inside the page: nothing from outside a function is there.

declare global {
  var frameTimes: number[]
}

/** Notes the time of every frame from now on. */
export function noteFrames() {
  globalThis.frameTimes = []
  const note = (time: number) => {
    globalThis.frameTimes.push(time)
    requestAnimationFrame(note)
  }
  requestAnimationFrame(note)
}

/** Frames between the next pointer movement and the next change below `changing`. */
export function framesUntilChange(changing: string) {
  return new Promise<number>((done) => {
    const began = () => globalThis.frameTimes.length
    let from = Infinity
    addEventListener('pointermove', () => (from = Math.min(from, began())), { capture: true, once: true })
    const watcher = new MutationObserver(() => {
      if (from === Infinity) return
      watcher.disconnect()
      done(began() - from)
    })
    for (const element of document.querySelectorAll(changing)) {
      watcher.observe(element, { subtree: true, characterData: true, childList: true, attributes: true })
    }
  })
}

/** Milliseconds from the next click, as the browser stamps it, to the first frame that shows the robot elsewhere. */
export function millisecondsToMove(robot: string) {
  return new Promise<number>((done) => {
    addEventListener(
      'click',
      ({ timeStamp }) => {
        const place = () => document.querySelector(robot)?.parentElement?.style.transform
        const before = place()
        const look = () => {
          if (place() === before) requestAnimationFrame(look)
          else done(performance.now() - timeStamp)
        }
        look()
      },
      { capture: true, once: true },
    )
  })
}
