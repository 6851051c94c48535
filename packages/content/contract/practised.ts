import type { Brain } from '@botgarten/learning/neural-network/brain'
import {
  afterLesson,
  beginLesson,
  practiceChoice,
  stepSettings,
} from '@botgarten/learning/neural-network/examples'
import { practiseFor, type CurvePoint } from '@botgarten/learning/neural-network/train'
import { networks } from '@botgarten/programs'
import { mirrorIn } from '@botgarten/programs/examples'
import { content } from '../files.ts'
import type { CardProgram } from '../index.ts'

/** The brain of a card's program after it has practised its own examples again with this seed, from where it began. */
export function practised(
  id: string,
  program: CardProgram,
  seed: number,
): { readonly brain: Brain; readonly curve: readonly CurvePoint[] } {
  const network = Object.values(program.programs).flatMap(networks)[0]!
  const brain = program.brains[network.id]!
  const choice = practiceChoice(brain)
  const { keepBack, from, mirror } = choice.settings
  const config = content.card(id)!.world.robots[0]!.config
  const lesson = beginLesson(
    {
      ...{ id: network.id, layers: brain.layers, weights: brain.practice!.start, examples: brain.examples! },
      ...{ seed, keepBack, from, mirror: mirror ? mirrorIn(network, config) : null },
    },
    stepSettings(choice),
  )
  practiseFor(lesson.practice, lesson.curve, Infinity)
  return { brain: afterLesson(brain, lesson), curve: lesson.curve }
}
