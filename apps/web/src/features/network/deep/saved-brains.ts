import { emptyBrain, weightsOf, withWeights, type Brain } from '@botgarten/learning/neural-network'
import { networks, type NetworkOutline } from '@botgarten/programs'
import { BrainError, brainFile, fitBrain, parseBrainFile, shelfName } from '@botgarten/programs/brain-file'
import type { LabSession } from '#lab/session.svelte.ts'
import { handOut } from '#storage/handout.ts'
import { message } from '#words/message.ts'

const brainOf = (session: LabSession, id: string): Brain => session.lab.document.brains[id] ?? emptyBrain
const robotsOf = (session: LabSession) => session.lab.document.world.robots

/** What lies on a network's list: its named weights, those left out that a robot drives with. */
export function savedBrains(session: LabSession, { id }: NetworkOutline): string[] {
  const driven = robotsOf(session).map(({ brain }) => brain)
  return Object.keys(brainOf(session, id).sets).filter((name) => !driven.includes(name))
}

const taken = (session: LabSession, id: string) => [
  ...Object.keys(brainOf(session, id).sets),
  ...robotsOf(session).map((robot) => robot.id),
]

/** Puts the weights on the knobs on the list, under a name that is free. */
export function put(session: LabSession, { id }: NetworkOutline, wanted: string): void {
  const name = shelfName(wanted, taken(session, id), message('net.brain'))
  session.weights.change(id, (brain) => withWeights(brain, weightsOf(brain, session.robot.brain), name))
}

/** Puts weights from the list on the knobs. */
export const take = (session: LabSession, { id }: NetworkOutline, name: string): void =>
  session.weights.change(id, (brain) => withWeights(brain, weightsOf(brain, name), session.robot.brain))

export function remove(session: LabSession, { id }: NetworkOutline, name: string): void {
  session.weights.change(id, (brain) => {
    const { [name]: _, ...sets } = brain.sets
    return { ...brain, sets }
  })
}

export function rename(session: LabSession, { id }: NetworkOutline, name: string, wanted: string): void {
  const others = taken(session, id).filter((other) => other !== name)
  const next = shelfName(wanted, others, name)
  if (next === name) return
  session.weights.change(id, (brain) => {
    const sets = Object.entries(brain.sets).map(([key, set]) => [key === name ? next : key, set])
    return { ...brain, sets: Object.fromEntries(sets) as Brain['sets'] }
  })
}

const fileOf = (session: LabSession, net: NetworkOutline, name: string) => {
  const brain = brainOf(session, net.id)
  return brainFile(name, brain, net, weightsOf(brain, name))
}

/** Hands a brain out as a file. @throws {BrainError} where it could not be opened again */
export function save(session: LabSession, net: NetworkOutline, name: string): void {
  const text = JSON.stringify(fileOf(session, net, name))
  parseBrainFile(text)
  handOut(name, text, 'brain.json')
}

/** Lays a brain from a file on the list. Returns its name there. @throws {BrainError} */
export function load(session: LabSession, net: NetworkOutline, text: string): string {
  const file = parseBrainFile(text)
  const name = shelfName(file.name, taken(session, net.id), message('net.brain'))
  session.weights.change(net.id, (before) => {
    const { brain, weights } = fitBrain(file, before, net)
    return withWeights(brain, weights, name)
  })
  return name
}

/** Robots that a brain can be given to: all others in the world, by their place among all robots. */
export const others = (session: LabSession): readonly { readonly id: string; readonly index: number }[] =>
  robotsOf(session).flatMap(({ id }, index) => (id === session.robotId ? [] : [{ id, index }]))

/** Another robot drives with these weights from now on. @throws {BrainError} where its network is another one */
export function give(session: LabSession, net: NetworkOutline, name: string, robot: string): void {
  const to = robotsOf(session).find(({ id }) => id === robot)
  const program = to && session.lab.document.programs[to.program]
  const nets = program ? networks(program) : []
  const target = nets.find(({ id }) => id === net.id) ?? nets[0]
  if (!to || !target) throw new BrainError('otherProgram', { there: '', here: '' })
  const file = fileOf(session, net, name)
  session.weights.change(target.id, (before) => {
    const { brain, weights } = fitBrain(file, before, target)
    return withWeights(brain, weights, to.brain)
  })
}
