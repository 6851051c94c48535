import { cardDocument } from '@botgarten/content/document'
import { rideOf as rideIn } from '@botgarten/experiments'
import { learningIn } from '@botgarten/programs'
import { paintFloor, type LedColour, type Pose, type World } from '@botgarten/simulation'
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
  const { poses, end } = rideIn(document, paintFloor(world, picture ?? undefined), run.seconds)
  const points = poses.filter((_, tick) => tick % EVERY === 0)
  return { id: loaded.card.world, world, poses: points, led: end.led }
}

/** What a program that learns is asked to learn. */
export async function taskOf(card: string, file: string) {
  const { program } = await programOf(card, file)
  return Object.values(program.programs).flatMap((one) => learningIn(one) ?? [])[0]!
}
