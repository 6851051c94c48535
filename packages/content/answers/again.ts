import type { Brain } from '@botgarten/learning/neural-network/brain'
import {
  afterLesson,
  beginLesson,
  practiceChoice,
  stepSettings,
} from '@botgarten/learning/neural-network/examples'
import { practiseFor, type CurvePoint } from '@botgarten/learning/neural-network/train'
import { beginNight, ticksOf, type Night } from '@botgarten/lab/trying'
import { networks, tryingIn } from '@botgarten/programs'
import { mirrorIn } from '@botgarten/programs/examples'
import type { Floor, RobotConfig, World } from '@botgarten/simulation'
import type { CardProgram } from '../schema/cardTypes.ts'

// What content has learned is learned again, from where it began.

/**
 * The brain of a program after it has practised its own examples again, with this seed or its own.
 * @throws TypeError for one that has not practised
 */
export function practisedAgain(
  program: Pick<CardProgram, 'programs' | 'brains'>,
  config: RobotConfig,
  seed?: number,
): { readonly brain: Brain; readonly curve: readonly CurvePoint[] } {
  const network = Object.values(program.programs).flatMap(networks)[0]
  const brain = program.brains[network?.id ?? '']
  if (!network || !brain?.practice || !brain.examples) throw new TypeError('Its network has not practised.')
  const choice = practiceChoice(brain)
  const { keepBack, from, mirror } = choice.settings
  const lesson = beginLesson(
    {
      ...{ id: network.id, layers: brain.layers, weights: brain.practice.start, examples: brain.examples },
      ...{ seed: seed ?? brain.practice.seed, keepBack, from },
      mirror: mirror ? mirrorIn(network, config) : null,
    },
    stepSettings(choice),
  )
  practiseFor(lesson.practice, lesson.curve, Infinity)
  return { brain: afterLesson(brain, lesson), curve: lesson.curve }
}

/** What a program has tried, from where the world has its robot. @throws TypeError for one that tries nothing */
export function triedAgain({ programs }: Pick<CardProgram, 'programs'>, world: World, floor: Floor): Night {
  const outline = Object.values(programs).flatMap((program) => tryingIn(program) ?? [])[0]
  if (!outline) throw new TypeError('It does not try.')
  const night = beginNight(world, floor, outline.trial)
  night.advance(ticksOf(outline.minutes))
  return night
}
