// A process that runs files one after the other and says what each told the robot. Who asked ends it where a file never waits.
import { once } from 'node:events'
import { runPython } from './micropython.ts'
import { chance, enough, tracingRobot, type Command } from './tracing-robot.ts'

/** A run of one of the files. `error`: what ended it; null: its last line, or time was up. */
export interface Traced {
  readonly index: number
  readonly log: readonly Command[]
  readonly error: string | null
  readonly cut: boolean
  readonly printed: readonly string[]
}

async function traced(text: string, index: number, ticks: number): Promise<Traced> {
  const { robot, log } = tracingRobot()
  let tick = 0
  const clock = {
    tick() {
      if (++tick > ticks) throw new Error(enough)
    },
    random: chance(),
  }
  const { error, printed } = await runPython(text, robot, clock)
  const cut = error !== null && error.includes(enough)
  return { index, log, error: cut ? null : error, cut, printed }
}

const [{ texts, from, ticks }] = (await once(process, 'message')) as [
  { readonly texts: readonly string[]; readonly from: number; readonly ticks: number },
]
for (let index = from; index < texts.length; index++) {
  process.send!({ begun: index })
  process.send!(await traced(texts[index]!, index, ticks))
}
process.disconnect()
