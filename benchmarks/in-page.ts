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

/** Asks for the frames between the next pointer movement and the first that shows another number at what answers to a hand. */
export function askFramesUntilChange(button: Element) {
  globalThis.answer = new Promise<number>((done) => {
    const { x, y, width, height } = button.getBoundingClientRect()
    const number = () =>
      globalThis
        .botgarten!.places()
        .find(({ text, ...at }) => text && Math.hypot(at.x - x - width / 2, at.y - y - height / 2) < 2)?.text
    const before = number()
    const begin = () => {
      const from = globalThis.frameTimes.length
      const look = () => {
        if (number() === before) requestAnimationFrame(look)
        else done(globalThis.frameTimes.length - from)
      }
      look()
    }
    addEventListener('pointermove', begin, { capture: true, once: true })
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

/** How many of eight places so many px around each knob that is seen answer to a finger. */
export function placesThatAnswer(away: number) {
  const room = document.querySelector('.playground .scroll')!.getBoundingClientRect()
  const around = [...document.querySelectorAll('.playground [role=slider]')].flatMap((knob) => {
    const { x, y, width, height } = knob.getBoundingClientRect()
    return Array.from({ length: 8 }, (_, k) => ({
      x: x + width / 2 + away * Math.cos((k * Math.PI) / 4),
      y: y + height / 2 + away * Math.sin((k * Math.PI) / 4),
    }))
  })
  const seen = around.filter(
    ({ x, y }) => x > room.left && x < room.right - 12 && y > room.top && y < room.bottom - 12,
  )
  // Released builds before it was painted cannot be asked.
  const answers = ({ x, y }: { readonly x: number; readonly y: number }) =>
    globalThis.botgarten ? globalThis.botgarten.partAt(x, y) !== null : false
  return { answer: seen.filter(answers).length, places: seen.length }
}
