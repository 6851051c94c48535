import courses from 'content:courses'
import type { Ground, LaneKind, Racer } from '@botgarten/experiments/brain-race'
import { networks, tryingIn, type Project, type Raced } from '@botgarten/programs'
import { loadWorld, placeOf } from '#content/cards.ts'
import { shownName } from '#content/names.ts'
import { Floors } from '#lab/floor/floors.ts'
import { list, open as openProject, save } from '#storage/projects.ts'

/** A course that is open: where it is, its own brains, and those of this device. */
export interface OpenCourse {
  readonly ground: Ground
  readonly given: { readonly [kind in LaneKind]: Racer | null }
  readonly own: { readonly [kind in LaneKind]: readonly OwnBrain[] }
  /** The project that a child has come with; null: none, or this device has it no longer. */
  readonly mine: Mine | null
}

/** A project of this device that can drive in a lane. */
interface OwnBrain {
  readonly id: string
  readonly name: string
  readonly racer: Racer
}

interface Mine {
  readonly id: string
  /** Null: it is no brain for any lane. */
  readonly kind: LaneKind | null
  /** The card that it is for, or `free`. */
  readonly card: string
}

/** Ids of all courses, with the world of each. */
export const allCourses = courses.map(({ course: { id, world } }) => ({ id, world }))

/** @param project id of the one that a child has come with. Null where there is no such course. */
export async function openCourse(id: string, project: string | null = null): Promise<OpenCourse | null> {
  const found = courses.find(({ course }) => course.id === id)
  if (!found) return null
  const { course, racers } = found
  const [world, { projects }] = await Promise.all([loadWorld(course.world), list()])
  const floors = new Floors()
  await floors.load(world, {})
  const brains = projects.map((one) => ({ ...one, kind: kindOf(one.project), name: shownName(one) }))
  const ownFor = (kind: LaneKind) =>
    brains
      .filter((one) => one.kind === kind)
      .map((one) => ({ id: one.id, name: one.name, racer: racerOf(one.project) }))
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
