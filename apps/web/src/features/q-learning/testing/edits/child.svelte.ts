// A lab under random edits: the session, its screen state and the playground for learning, on a fake clock and a fake device.
import { addBlocks, knowMaps } from '@botgarten/blocks'
import { expert } from '@botgarten/blocks/packs/expert'
import { learning } from '@botgarten/blocks/packs/learning'
import { cardProject } from '@botgarten/content'
import { content } from '@botgarten/content/files'
import { parseProject, type Program, type Project } from '@botgarten/programs'
import { paintFloor } from '@botgarten/simulation'
import { flushSync } from 'svelte'
import { loadCard, type LoadedCard } from '#content/cards.ts'
import { sentenceOf } from '#features/missed/sentence.ts'
import { Learning } from '#features/q-learning/model/learning.svelte.ts'
import {
  driveOf,
  endOf,
  liveSentence,
  reasonOf,
  tieOf,
  watchedOf,
} from '#features/q-learning/view/messages.ts'
import { LabSession } from '#lab/session.svelte.ts'
import { LabUi } from '#lab/ui.svelte.ts'
import { load, save } from '#storage/projects.ts'
import { message } from '#words/message.ts'
import { taskOf } from '#app/lab-screen/card.ts'
import { withFields, withRoads } from './programs.ts'

addBlocks(learning)
addBlocks(expert)
knowMaps(content)

const cards: { [id: string]: LoadedCard } = {}
async function cardOf(id: string): Promise<LoadedCard> {
  return (cards[id] ??= (await loadCard(id))!)
}

/** The program with its step before and after, as the editor has it: each edit of the blocks is one step of its own. */
class Editor {
  readonly #session: LabSession
  #before: Program[] = []
  #after: Program[] = []

  constructor(session: LabSession) {
    this.#session = session
    session.moveBlocks = (direction, program) => this.#move(direction, program)
  }

  change(edit: (program: Program) => Program): void {
    const { robot, program } = this.#session
    const after = edit(program)
    if (after === program) return
    this.#before.push(program)
    this.#after = []
    this.#session.noteBlocks(robot.program)
    this.#session.apply({ kind: 'program', program: robot.program, after })
  }

  #move(direction: 'undo' | 'redo', name: string): boolean {
    const [from, to] = direction === 'undo' ? [this.#before, this.#after] : [this.#after, this.#before]
    const program = from.pop()
    const now = this.#session.lab.document.programs[name]
    if (!program || !now) return false
    to.push(now)
    this.#session.apply({ kind: 'program', program: name, after: program }, 'silent')
    return true
  }
}

/** One lab, opened from a project. */
export class Lab {
  readonly session: LabSession
  readonly ui: LabUi
  readonly editor: Editor
  readonly learning: Learning | null
  readonly card: LoadedCard
  /** The first error of a note. */
  fault: Error | null = null
  readonly #close: readonly (() => void)[]

  constructor(card: LoadedCard, id: string, project: Project, revision: number) {
    this.card = card
    this.session = new LabSession({
      ...{ id, revision, project, card, expert: true, keeps: true },
      ...{ floor: floorFor(project), floorAddress: null, error: null, damaged: null },
    })
    this.session.paint = (scene) => paintFloor(scene)
    this.editor = new Editor(this.session)
    this.ui = new LabUi(this.session)
    const blocks = {
      setFields: (block: string, fields: { readonly [name: string]: string }) =>
        this.editor.change((program) => withFields(program, block, fields)),
      setClosed: (map: string, roads: readonly (readonly [number, number])[]) =>
        this.editor.change((program) => withRoads(program, map, roads)),
    }
    this.learning = this.session.learns ? new Learning(this.session, this.ui, blocks, 1) : null
    this.#close = [this.ui.open(), this.learning?.open() ?? (() => {}), this.#follow()]
    flushSync()
  }

  /** Reads the notes of the playground whenever one of them changes, as components do: between two edits, too. */
  #follow(): () => void {
    return $effect.root(() => {
      $effect(() => {
        try {
          if (this.learning) notesOf(this.learning)
        } catch (cause) {
          this.fault ??= cause instanceof Error ? cause : new Error(String(cause))
        }
      })
    })
  }

  /** Is the first robot under way by its program? */
  get moves(): boolean {
    const { phase, robots } = this.session.lab.view
    return phase === 'running' && Object.values(robots[0]?.motors ?? {}).some((percent) => percent !== 0)
  }

  /** Does a finding keep the program from running? */
  get stuck(): boolean {
    return this.session.findings.some(({ stops }) => stops)
  }

  /** Every sentence and note that the screen would show now. */
  notes(): readonly string[] {
    const { session, ui, learning, card } = this
    const { green } = session.lab.facts
    const goals = taskOf(card, green.split(' '), ui.earned, learning?.task.elsewhere ?? null)
    return [
      goals.title,
      goals.sentence,
      ...goals.goals.map(({ label }) => label),
      ...(ui.missed ? [sentenceOf(ui.missed, '')] : []),
      ...session.lab.missing().map((one) => sentenceOf(one, '')),
      ...session.findings.flatMap(({ problem, facts }) => [
        message(`${problem}.title`, facts),
        message(`${problem}.text`, facts),
      ]),
      ...(ui.notice ? [message(`session.${ui.notice}`)] : []),
      ...(learning ? notesOf(learning) : []),
    ]
  }

  close(): void {
    for (const close of this.#close.toReversed()) close()
  }
}

function notesOf(learning: Learning): readonly string[] {
  const { shown, watch, drive } = learning
  if (!shown) return []
  return [
    endOf(learning),
    reasonOf(learning, 'starter'),
    reasonOf(learning, 'expert'),
    tieOf(learning),
    liveSentence(learning),
    ...(watch.on ? [watchedOf(learning)] : []),
    // As the screen decides it: once Bo has driven, the floor is in front.
    ...(drive.front === 'floor' ? [driveOf(learning).text] : []),
  ]
}

const floors: { [scene: string]: ReturnType<typeof paintFloor> } = {}
function floorFor({ world }: Project) {
  if (!('asset' in world.floor)) return paintFloor(world)
  const key = JSON.stringify([world.size, world.floor, world.areas, world.lines])
  return (floors[key] ??= content.floorOf(world))
}

/** The card with its solution, so that Bo moves from the beginning. */
export async function openCard(card: string, id: string): Promise<Lab> {
  const loaded = await cardOf(card)
  const solved = cardProject(loaded.world, loaded.card, content.program(card, 'solution')!, card)
  const project = { ...solved, progress: { starts: [], hints: 0 } }
  const saved = await save(id, project, 0)
  return new Lab(loaded, id, project, saved.kind === 'saved' ? saved.revision : 0)
}

/** The project as the device has it, which is as it is on the screen, and can be read again from its file. */
export async function reopened(lab: Lab): Promise<{ readonly lab: Lab; readonly lost: string | null }> {
  const { session } = lab
  lab.close()
  const wanted = session.project
  const { id } = session.autosave
  const file = JSON.stringify(wanted)
  await session.autosave.flush()
  const saved = await load(id)
  const fromFile = parseProject(JSON.parse(file) as unknown)
  const lost = !saved
    ? `nothing is saved (${session.autosave.storage})`
    : (differenceOf(wanted, saved.project) ?? differenceOf(wanted, fromFile))
  return { lab: new Lab(lab.card, id, saved?.project ?? wanted, saved?.revision ?? 0), lost }
}

/** Parts that saving writes: the format's version as the project needs it, and the effort, saved with the next edit. */
const derived: readonly string[] = ['botgarten', 'effort']

/** The first part in which two projects differ; null if there is none. */
function differenceOf(wanted: Project, got: Project): string | null {
  const names = [...new Set([...Object.keys(wanted), ...Object.keys(got)])] as (keyof Project)[]
  const lost = names
    .filter((name) => !derived.includes(name))
    .find((name) => !isEqual(wanted[name], got[name]))
  if (lost === undefined) return null
  const [before, after] = [wanted[lost], got[lost]].map((part) => JSON.stringify(part) ?? '')
  const at = Array.from(before!).findIndex((letter, index) => letter !== after![index])
  return `${lost}: …${before!.slice(Math.max(0, at - 80), at + 80)} became …${after!.slice(Math.max(0, at - 80), at + 80)}`
}

function isEqual(a: unknown, b: unknown): boolean {
  if (Object.is(a, b)) return true
  if (typeof a !== 'object' || typeof b !== 'object' || a === null || b === null) return false
  const [one, other] = [a, b] as { readonly [key: string]: unknown }[]
  const keys = new Set([...Object.keys(one!), ...Object.keys(other!)])
  return [...keys].every((key) => isEqual(one![key], other![key]))
}
