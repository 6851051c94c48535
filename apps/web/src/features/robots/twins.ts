import { weightsOf, type Brain, type Weights } from '@botgarten/learning/neural-network'
import type { NetworkOutline } from '@botgarten/programs'
import type { RobotPlacement } from '@botgarten/simulation'

export interface Link {
  readonly from: string
  readonly to: string
}

/** Another robot with the same blocks and a weight set of its own. */
export interface Twin {
  readonly robot: string
  /** Its place among all robots, from 0. */
  readonly index: number
  readonly weights: Weights
}

/** What a session knows of robots and weights. */
interface Known {
  readonly robotId: string
  readonly outlines: readonly NetworkOutline[]
  readonly lab: {
    readonly document: { readonly world: { readonly robots: readonly RobotPlacement[] } }
    readonly facts: { readonly brains: { readonly [network: string]: Brain } }
  }
}

/** Weights of the chosen robot in the network that is shown, and the robots that run the same one with other sets. */
export function twinsOf({ robotId, outlines, lab }: Known): { own: Weights; twins: readonly Twin[] } {
  const { robots } = lab.document.world
  const brain = lab.facts.brains[outlines[0]?.id ?? '']
  const chosen = robots.find(({ id }) => id === robotId)
  if (!brain || !chosen) return { own: {}, twins: [] }
  const twins = robots.flatMap((robot, index) =>
    robot.program === chosen.program && robot.brain !== chosen.brain
      ? [{ robot: robot.id, index, weights: weightsOf(brain, robot.brain) }]
      : [],
  )
  return { own: weightsOf(brain, chosen.brain), twins }
}

/** All links of the network that is shown. */
export const linksOf = ({ outlines: [net] }: Pick<Known, 'outlines'>): readonly Link[] =>
  net?.inputs.flatMap(({ id: from }) => net.outputs.map(({ id: to }) => ({ from, to }))) ?? []

export const weightIn = (weights: Weights, { from, to }: Link): number => weights[from]?.[to] ?? 0

/** Those of `twins` that give a link another weight. */
export const differing = (own: Weights, twins: readonly Twin[], link: Link): readonly Twin[] =>
  twins.filter(({ weights }) => weightIn(weights, link) !== weightIn(own, link))
