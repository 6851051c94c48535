import {
  emptyBrain,
  weightsOf,
  withWeights,
  type Brain,
  type Weights,
} from '@botgarten/learning/neural-network'
import { networks, type NetworkOutline, type NeuronOutline, type Project } from '@botgarten/programs'
import { BrainError, brainFile, fitBrain, shelfName } from '@botgarten/programs/brain-file'
import type { RobotConfig, SensorPort } from '@botgarten/simulation'

/** The network of a project's first robot. */
interface OwnBrain {
  readonly net: NetworkOutline
  readonly brain: Brain
  readonly weights: Weights
  readonly config: RobotConfig
  /** Name of the weight set that the robot drives with. */
  readonly set: string
}

/** Null where the first robot has no network. */
export function brainOf({ programs, brains, world }: Project): OwnBrain | null {
  const robot = world.robots[0]
  const program = robot && programs[robot.program]
  const net = program && networks(program)[0]
  if (!net) return null
  const brain = brains[net.id] ?? emptyBrain
  return { net, brain, weights: weightsOf(brain, robot.brain), config: robot.config, set: robot.brain }
}

/** Two neurons that stand for each other and do not read or move the same. */
interface Difference {
  readonly there: NeuronOutline
  readonly here: NeuronOutline
  /** Only the place of the sensor on the robot is another one. */
  readonly placeOnly: boolean
}

interface Fit {
  readonly brain: Brain
  readonly weights: Weights
  readonly differences: readonly Difference[]
}

const portOf = ({ look, fields }: NeuronOutline) => (look.port && fields[look.port]?.at(-1)) ?? ''

const placeOf = (neuron: NeuronOutline, { sensors }: RobotConfig) => {
  const { kind, x, y, angle } = sensors[portOf(neuron) as SensorPort] ?? {}
  return JSON.stringify([kind, x, y, angle])
}

/** Neurons that have the same id, else those in the same place of their layer: as `fitBrain` pairs them. */
function pairs(there: readonly NeuronOutline[], here: readonly NeuronOutline[]) {
  const isNamed = there.every(({ id, type }) => here.some((own) => own.id === id && own.type === type))
  return there.flatMap((neuron, at) => {
    const own = isNamed ? here.find(({ id }) => id === neuron.id) : here[at]
    return own ? [[neuron, own] as const] : []
  })
}

function differencesOf(there: OwnBrain, here: OwnBrain): Difference[] {
  const all = [...pairs(there.net.inputs, here.net.inputs), ...pairs(there.net.outputs, here.net.outputs)]
  return all.flatMap(([one, own]) => {
    const sameFields = JSON.stringify(one.fields) === JSON.stringify(own.fields)
    const samePlace = one.look.layer === 'output' || placeOf(one, there.config) === placeOf(own, here.config)
    return sameFields && samePlace ? [] : [{ there: one, here: own, placeOnly: sameFields }]
  })
}

/** The weights of a brain under the names of another program's network; null where its layers are others. */
export function fitted(from: OwnBrain, into: OwnBrain): Fit | null {
  try {
    const file = brainFile('', from.brain, from.net, from.weights)
    return { ...fitBrain(file, into.brain, into.net), differences: differencesOf(from, into) }
  } catch (error) {
    if (error instanceof BrainError) return null
    throw error
  }
}

/**
 * The own project with the weights of another brain on its knobs. What was on them stays among its saved brains.
 * @param before name of that saved brain
 */
export function withBrain(project: Project, into: OwnBrain, fit: Fit, before: string): Project {
  const taken = [...Object.keys(into.brain.sets), ...project.world.robots.map(({ id }) => id)]
  const name = shelfName(before, taken, 'brain')
  const saved = withWeights(fit.brain, into.weights, name)
  const brain = withWeights(saved, fit.weights, into.set)
  return { ...project, brains: { ...project.brains, [into.net.id]: brain } }
}
