import { createLab, type Check, type Lab } from '@botgarten/lab'
import type { Floor, World } from '@botgarten/simulation'
import type { Entry, EventName } from './log/code-book.ts'
import type { Fault, Numbered } from './log/read.ts'

/** What a replay asks of the product. */
export interface Ground {
  /** The floor of a world whose picture ships with the product. */
  readonly floorOf: (world: World) => Floor
  /** Checks of a card; none where it has none, or is not known. */
  readonly checksOf: (place: string) => readonly Check[]
}

/** One run that was played again. */
export interface PlayedRun {
  /** Line of the file where it ended. */
  readonly line: number
  readonly session: string
  readonly pseudonym: string
  readonly ticks: number
  readonly hash: string
  /** What it came to now. */
  readonly again: string
  /** A picture of the child's own was left out: nothing can be said about the hash. */
  readonly photo: boolean
}

export interface Replay {
  readonly runs: readonly PlayedRun[]
  readonly faults: readonly Fault[]
  /** Versions of Botgarten that wrote the sessions. */
  readonly versions: readonly string[]
}

/** Was a run the same again, as far as that can be said? */
export const isSame = ({ hash, again, photo }: PlayedRun): boolean => photo || hash === again

interface Stage {
  readonly lab: Lab
  photo: boolean
}

/** Plays a log again, session by session, and compares the hash of every run. */
export function replay(lines: readonly Numbered[], ground: Ground): Replay {
  const stages = new Map<string, Stage>()
  const runs: PlayedRun[] = []
  const faults: Fault[] = []
  const versions = new Set<string>()
  for (const { line, says } of lines) {
    const { session, pseudonym } = says
    const stage = stages.get(session) ?? { lab: createLab(), photo: false }
    stages.set(session, stage)
    if (says.event === 'session') versions.add(says.version)
    try {
      play(stage, says, ground)
    } catch (error) {
      const why = error instanceof Error ? error.message.slice(0, 160) : ''
      faults.push({ line, reason: 'cannotPlay', facts: { event: says.event, why } })
    }
    if (says.event !== 'end') continue
    const { ticks, hash } = says
    runs.push({ line, session, pseudonym, ticks, hash, again: stage.lab.hash(), photo: stage.photo })
  }
  return { runs, faults, versions: [...versions] }
}

function play(stage: Stage, says: Entry, ground: Ground): void {
  if (says.event === 'open') stage.photo = says.photo
  if (says.event === 'rebuild') stage.photo ||= says.photo
  const act = acts[says.event] as (lab: Lab, says: Entry, ground: Ground) => void
  act(stage.lab, says, ground)
}

const nothing = () => {}

const acts: {
  readonly [Name in EventName]: (lab: Lab, says: Extract<Entry, { event: Name }>, ground: Ground) => void
} = {
  open: (lab, { document, place, seed }, { floorOf, checksOf }) =>
    lab.load(document, floorOf(document.world), { seed, checks: checksOf(place) }),
  edit: (lab, { programs, fromStart }) => lab.edit({ ...lab.document().programs, ...programs }, fromStart),
  rebuild: (lab, { document, floor, stood }, { floorOf }) =>
    lab.rebuild(document, floor ? floorOf(document.world) : undefined, stood),
  knob: (lab, { brain, from, to, weight, set }) => lab.setWeight(brain, from, to, weight, set),
  brain: (lab, { brain, value }) => lab.setBrain(brain, value),
  training: (lab, { brain, change, without }) =>
    lab.setTraining(brain, { ...change, ...Object.fromEntries(without.map((part) => [part, null])) }),
  time: (lab, { ticks, practising }) => passTime(lab, ticks, practising),
  run: (lab) => lab.start(),
  stop: (lab) => lab.stop(),
  pause: (lab) => lab.pause(),
  resume: (lab) => lab.resume(),
  reset: (lab) => lab.reset(),
  step: (lab, { step, robot }) => lab.step(step, robot),
  stops: (lab, { blocks }) => lab.setStops(blocks),
  look: (lab, { tick }) => lab.goTo(tick),
  branch: (lab) => lab.branch(),
  swap: (lab) => void lab.swap(),
  place: (lab, { thing, pose, start }) => void lab.place(thing, pose, start ?? undefined),
  key: (lab, { key, down, robot }) => lab.press(key, down, robot),
  button: (lab, { button, down, robot }) => lab.pressButton(button, down, robot),
  pad: (lab, { hand, robot }) => lab.drive(hand, hand?.others, robot),
  record: (lab, { recording }) => lab.record(recording),
  remember: (lab, { row }) => void lab.remember(row),
  ...{ session: nothing, part: nothing, end: nothing, check: nothing, hint: nothing },
  ...{ learned: nothing, rest: nothing, over: nothing },
}

/** Practice that the last of these ticks asked for, and that was still under way, has not been done yet. */
function passTime(lab: Lab, ticks: number, practising: boolean): void {
  lab.advance(practising ? ticks - 1 : ticks)
  if (practising) lab.advance(1, 0)
}
