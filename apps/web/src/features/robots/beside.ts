import type { Document } from '@botgarten/lab'
import { weightsOf, withWeights, type Brain, type Weights } from '@botgarten/learning/neural-network'
import type { Beside } from '@botgarten/content'
import { networks, type Project } from '@botgarten/programs'
import { open } from '#storage/projects.ts'
import { withRobot } from '#lab/robots.ts'

type OfNetworks = { readonly [network: string]: Weights }

/** The document with a second robot for its first one's program, with the weights of another card under `name`. */
export function withBeside(
  document: Document,
  { pose, weights }: Pick<Beside, 'pose' | 'weights'>,
  name: string,
): { id: string; document: Document } {
  const first = document.world.robots[0]!
  const { id, document: grown } = withRobot(document, first.id, 'shared')
  const set = Object.values(document.brains).some(({ sets }) => Object.hasOwn(sets, name)) ? id : name
  const brains: { [network: string]: Brain } = { ...grown.brains }
  for (const network of networks(document.programs[first.program]!)) {
    const brain = document.brains[network.id]
    if (brain) brains[network.id] = withWeights(brain, weights[network.id] ?? {}, set)
  }
  const robots = grown.world.robots.map((robot) => (robot.id === id ? { ...robot, pose, brain: set } : robot))
  return { id, document: { ...grown, brains, world: { ...grown.world, robots } } }
}

/** What the child has found for that card on this device, else what solves it. */
export async function weightsFor({ card, weights }: Beside): Promise<OfNetworks> {
  const kept = await open(card)
  const own = kept && ownWeights(kept.project, Object.keys(weights))
  return own ?? weights
}

function ownWeights({ brains, world }: Project, ids: readonly string[]): OfNetworks | null {
  const set = world.robots[0]?.brain ?? ''
  const own = ids.map((id) => [id, brains[id] ? weightsOf(brains[id], set) : {}] as const)
  return own.some(([, weights]) => isSet(weights)) ? Object.fromEntries(own) : null
}

const isSet = (weights: Weights) => Object.values(weights).some((row) => Object.values(row).some(Boolean))
