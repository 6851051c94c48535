import courses from 'content:courses'
import type { Ground, LaneKind, Racer } from '@botgarten/experiments/brain-race'
import { networks, tryingIn, type Project, type Raced } from '@botgarten/programs'
import { loadWorld, placeOf } from '#content/cards.ts'
import { shownName } from '#content/names.ts'
import { Floors } from '#lab/floor/floors.ts'
import { askAs } from '#storage/ask.ts'
import { list, open as openProject, save } from '#storage/projects.ts'
import { sharedIn } from './shared.ts'

/** A course that is open: where it is, its own brains, and those of this device and of a class. */
export interface OpenCourse {
  readonly ground: Ground
  readonly given: { readonly [kind in LaneKind]: Racer | null }
  readonly own: { readonly [kind in LaneKind]: readonly OwnBrain[] }
  /** The project that a child has come with; null: none, or this device has it no longer. */
  readonly mine: Mine | null
  /** The class whose shared brains are among those of `own`; null: none was asked for. */
  readonly school: School | null
}

/** A project of this device, or one that a class has shared, that can drive in a lane. */
interface OwnBrain {
  readonly id: string
  readonly name: string
  /** Who has shared it; undefined: it is of this device. */
  readonly by?: string
  readonly racer: Racer
}

interface Mine {
  readonly id: string
  /** Null: it is no brain for any lane. */
  readonly kind: LaneKind | null
  /** The card that it is for, or `free`. */
  readonly card: string
}

interface School {
  readonly id: string
  /** How many brains it has shared; null: they cannot be had. */
  readonly shared: number | null
}

/** Ids of all courses, with the world of each. */
export const allCourses = courses.map(({ course: { id, world } }) => ({ id, world }))

/**
 * @param project id of the one that a child has come with
 * @param school id of the class whose shared brains may race
 * @returns null where there is no such course
 */
export async function openCourse(
  id: string,
  project: string | null = null,
  school: string | null = null,
  ask = askAs(null),
): Promise<OpenCourse | null> {
  const found = courses.find(({ course }) => course.id === id)
  if (!found) return null
  const { course, racers } = found
  const [world, { projects }, shared] = await Promise.all([
    loadWorld(course.world),
    list(),
    school === null ? [] : sharedIn(school, ask),
  ])
  const floors = new Floors()
  await floors.load(world, {})
  const ofDevice = projects.map((one) => ({ id: one.id, project: one.project, name: shownName(one) }))
  const ofClass = (shared ?? []).map(({ title: name, ...one }) => ({ ...one, name }))
  const brains = [...ofClass, ...ofDevice].map((one) => ({ ...one, kind: kindOf(one.project) }))
  const ownFor = (kind: LaneKind): readonly OwnBrain[] =>
    brains
      .filter((one) => one.kind === kind)
      .map(({ kind: _, project: of, ...one }) => ({ ...one, racer: racerOf(of) }))
  const mine = brains.find((one) => one.id === project)
  return {
    ground: { course, world, floor: floors.paint(world) },
    given: racers,
    own: {
      hand: ownFor('hand'),
      examples: ownFor('examples'),
      trying: ownFor('trying'),
      ifThen: ownFor('ifThen'),
    },
    mine: mine ? { id: mine.id, kind: mine.kind, card: placeOf(mine.project) } : null,
    school: school === null ? null : { id: school, shared: shared && ofClass.length },
  }
}

/** The program of its first robot, with its brains. */
function racerOf({ programs, brains, tables, world, effort }: Project): Racer {
  const main = world.robots[0]?.program ?? ''
  const program = programs[main]
  return {
    programs: program ? { [main]: program } : {},
    ...{ brains, ...(tables && { tables }), ...(effort && { effort }) },
  }
}

/** Which lane a project is for: a table, a network that has practised, one that a hand has set, or a program without any. */
export function kindOf(project: Project): LaneKind | null {
  const [program] = Object.values(racerOf(project).programs)
  if (!program) return null
  if (tryingIn(program)) return 'trying'
  const [net] = networks(program)
  if (!net) return 'ifThen'
  return (project.brains[net.id]?.practice?.round ?? 0) > 0 ? 'examples' : 'hand'
}

/** Writes into a project what came of a race. @returns whether it is saved */
export async function saveRaced(id: string, raced: Raced): Promise<boolean> {
  const kept = await openProject(id)
  if (!kept) return false
  const saved = await save(id, { ...kept.project, raced }, kept.revision)
  return saved.kind === 'saved'
}
