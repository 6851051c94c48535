import { createLab } from '@botgarten/lab'
import { cardDocument } from '@botgarten/content/document'
import { learningIn } from '@botgarten/programs'
import { paintFloor, TICKS_PER_SECOND, type LedColour, type Pose, type World } from '@botgarten/simulation'
import { pictureIn } from '#lab/floor/pictures.ts'
import type { Question } from '@botgarten/content/questions'
import { programOf } from '../programs.ts'

/** A run of the lab as a picture: where the robot began, where it went, and how it ended. */
export interface Ride {
  readonly id: string
  readonly world: World
  readonly poses: readonly Pose[]
  readonly led: LedColour | null
}

type LabRun = Extract<Question['run'], { seconds: number }>
/** So many ticks lie between two points of a trail. */
const EVERY = 5

/** Runs what a question asks about, as the tests do that check its answer. */
export async function rideOf(run: LabRun): Promise<Ride> {
  const { card: loaded, program } = await programOf(run.card, run.file)
  const document = cardDocument(loaded.world, loaded.card, program, run.start)
  const { world } = document
  const picture = 'asset' in world.floor ? await pictureIn(world, undefined) : undefined
  const lab = createLab()
  lab.load(document, paintFloor(world, picture ?? undefined), { seed: 1, checks: [] })
  const robot = () => lab.view().robots[0]!
  const poses = [robot().pose]
  lab.start()
  for (let tick = 0; tick < run.seconds * TICKS_PER_SECOND; tick += EVERY) {
    lab.advance(EVERY)
    poses.push(robot().pose)
  }
  return { id: loaded.card.world, world, poses, led: robot().led }
}

/** What a program that learns is asked to learn. */
export async function taskOf(card: string, file: string) {
  const { program } = await programOf(card, file)
  return Object.values(program.programs).flatMap((one) => learningIn(one) ?? [])[0]!
}
