import type { Teaching } from '@botgarten/blocks'
import { weightsOf, withoutWeights } from '@botgarten/learning/neural-network/brain'
import { errorOn } from '@botgarten/learning/neural-network/examples'
import { networksByUse, type Program } from '@botgarten/programs'
import { choiceIn } from '@botgarten/programs/examples'
import { exerciseOf, problemOf } from './exercise.ts'
import type { Ground, School } from './school.ts'

/** What blocks of a robot's program do with its first network. */
export function teachingOf(
  ground: Ground & { readonly school: School },
  index: number,
  program: Program,
): Teaching {
  const outline = networksByUse(program)[0]
  const set = ground.simulation.world.robots[index]!.brain
  if (!outline) return withoutNetwork
  const { id } = outline
  return {
    remember: () => (ground.school.rememberDone(index, id) ? null : 'examplesFull'),
    practise(rounds) {
      const problem = problemOf(exerciseOf(ground, index, id))
      if (problem === null) ground.school.want({ robot: index, network: id, rounds })
      return problem
    },
    forget(what) {
      if (what === 'examples') ground.school.take({ kind: 'training', brain: id, examples: null })
      else if (ground.brains[id]) ground.use(id, withoutWeights(ground.brains[id], set))
    },
    error() {
      const brain = ground.brains[id]
      const error =
        brain?.examples && errorOn(brain.layers, weightsOf(brain, set), brain.examples, choiceIn(outline))
      return error ?? 'noExamples'
    },
  }
}

const withoutNetwork: Teaching = {
  remember: () => 'nothingToTeach',
  practise: () => 'nothingToTeach',
  forget() {},
  error: () => 'nothingToTeach',
}
