import { createLab } from '@botgarten/lab'
import { networksByUse } from '@botgarten/programs'
import {
  mostOfCard,
  ownKinds,
  versionOf,
  type CardLanguage,
  type OwnCard,
  type OwnCheck,
  type OwnProgram,
  type Program,
  type Project,
} from '@botgarten/programs/project'
import { TICKS_PER_SECOND, type Floor, type Pose } from '@botgarten/simulation'
import type { Card } from './schema/cardTypes.ts'

// Cards that somebody makes in the lab: how one begins, and how it is proved.

/** Checks of a card that somebody could have chosen. */
export const choosable = (checks: readonly OwnCheck[]): readonly OwnCheck[] =>
  checks.filter(({ kind }) => Object.hasOwn(ownKinds, kind)).slice(0, mostOfCard.checks)

/**
 * A project as a card that is being made of it: its program is how the card is solved, and stays as it is.
 * @param like the card to which the project belongs: its places and checks are there to begin with
 */
export function draftOf(project: Project, title: string, language: CardLanguage, like?: Card): Project {
  const { card: _card, progress: _progress, q: _q, sorting: _sorting, madeFrom: _from, ...own } = project
  const solved = project.ownCard?.solution
  const draft: Project = { ...own, name: title, ...solved, ownCard: cardFor(project, title, language, like) }
  return { ...draft, botgarten: versionOf(draft) }
}

function cardFor(project: Project, title: string, language: CardLanguage, like?: Card): OwnCard {
  const { ownCard: before } = project
  if (before) {
    const { solution: _, ...rest } = before
    return { ...rest, draft: true, start: { programs: project.programs, brains: project.brains } }
  }
  const hints = ['', '', ''] as const
  return {
    text: { [language]: { title: title.slice(0, mostOfCard.title), story: '', task: '', hints } },
    starts: like?.starts.slice(0, mostOfCard.starts) ?? [rounded(project.world.robots[0]!.pose)],
    checks: like ? choosable(like.checks) : [],
    ...{
      grades: like?.grades ?? ([3, 12] as const),
      minutes: Math.min(like?.minutes ?? 20, mostOfCard.minutes),
    },
    blocks: { level: project.shelf ?? 'plain' },
    draft: true,
    start: hasKnobs(project) ? knobsAtZero(project) : onlyBegun(project),
  }
}

const rounded = ({ x, y, heading }: Pose): Pose => ({
  ...{ x: Math.round(x), y: Math.round(y) },
  heading: ((Math.round(heading) % 360) + 360) % 360,
})

type Both = Pick<Project, 'programs' | 'brains'>

/** Has it a network that decides, whose knobs could be turned back? */
export const hasKnobs = ({ programs, brains }: Both): boolean =>
  Object.values(programs)
    .flatMap(networksByUse)
    .some(({ id, idle }) => idle === null && Object.hasOwn(brains, id))

/** The same blocks with every knob at 0, and without what was practised. */
export const knobsAtZero = ({ programs, brains }: Both): OwnProgram => ({
  programs,
  brains: mapped(brains, ({ kind, layers, weights }) => ({
    kind,
    layers: layers.map((layer) => layer.map((neuron) => ({ ...neuron, bias: 0 }))),
    weights: mapped(weights, (row) => mapped(row, () => 0)),
    sets: {},
  })),
})

/** Of every program the block that it begins with. */
export const onlyBegun = ({ programs }: Both): OwnProgram => ({
  programs: mapped(programs, (program): Program => {
    const [stack] = program.stacks
    return { ...program, stacks: stack ? [{ ...stack, blocks: stack.blocks.slice(0, 1) }] : [] }
  }),
  brains: {},
})

/** The program of another project's first robot, for every robot of this one. */
export function programFor({ world }: Pick<Project, 'world'>, other: Project): OwnProgram {
  const theirs = other.programs[other.world.robots[0]!.program]!
  return {
    programs: Object.fromEntries(world.robots.map(({ program }) => [program, theirs])),
    brains: other.brains,
  }
}

const mapped = <From, To>(all: { readonly [key: string]: From }, change: (one: From) => To) =>
  Object.fromEntries(Object.entries(all).map(([key, one]) => [key, change(one)]))

/** What came of a run. `reached`: all checks were green at some moment; `solved`: they were at its end, too. */
export interface Outcome {
  readonly reached: boolean
  readonly solved: boolean
}

/** A card is tried for so long at least, in seconds: as long as the cards of the house. */
const shortest = 60
/** Ticks between two pauses. */
const slice = 30

/** Lets Bo drive a program from a place, without a picture. Pauses every half second of Bo's time. */
export function* tryCard(
  { world }: Pick<Project, 'world'>,
  { programs, brains }: OwnProgram,
  { checks }: Pick<OwnCard, 'checks'>,
  { start, floor }: { readonly start: Pose; readonly floor: Floor },
): Generator<undefined, Outcome> {
  const robots = world.robots.map((robot, index) => (index === 0 ? { ...robot, pose: start } : robot))
  const lab = createLab()
  lab.load({ programs, brains, world: { ...world, robots } }, floor, { seed: 1, checks })
  lab.start()
  const ticks = Math.max(shortest, ...checks.map(({ seconds }) => seconds)) * TICKS_PER_SECOND
  let [reached, solved] = [false, false]
  for (let tick = 0; tick < ticks; tick += slice) {
    lab.advance(slice)
    solved = checks.length > 0 && lab.view().checks.every(({ passed }) => passed)
    reached ||= solved
    yield
  }
  return { reached, solved }
}

/** The same at once. */
export function tried(...run: Parameters<typeof tryCard>): Outcome {
  const going = tryCard(...run)
  for (;;) {
    const { done, value } = going.next()
    if (done) return value
  }
}
