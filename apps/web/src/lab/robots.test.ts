import { content } from '@botgarten/content/files'
import type { Document } from '@botgarten/lab'
import { brainsFor, createLab } from '@botgarten/lab'
import { biasRow, withWeight } from '@botgarten/learning/neural-network'
import { networks, parseProject, type Program } from '@botgarten/programs'
import { cardConfig, paintFloor, type World } from '@botgarten/simulation'
import { describe, expect, it } from 'vitest'
import { withoutRobot, withRobot } from './robots.ts'

const solution = content.program('friendship', 'solution')!

const world: World = {
  size: { width: 300, height: 300 },
  floor: { colour: '#FFFFFF' },
  areas: [],
  lines: [],
  obstacles: [],
  robots: [
    { id: 'bo', pose: { x: 100, y: 100, heading: 90 }, program: 'main', brain: '', config: cardConfig },
  ],
}
const document: Document = { ...solution, world, brains: brainsFor(solution.programs, solution.brains) }
const netOf = (program: Program) => networks(program)[0]!
const net = netOf(document.programs['main']!)
const [eye, wheel] = [net.inputs[0]!.id, net.outputs[0]!.id]
const isProject = (one: Document) => parseProject({ botgarten: 1, name: 'two', ...one, assets: {} })

describe('a robot more', () => {
  it('with a program of its own keeps its biases', () => {
    const brain = withWeight(document.brains[net.id]!, biasRow, wheel, -7)
    const { id, document: two } = withRobot({ ...document, brains: { [net.id]: brain } }, 'bo', 'own')
    expect(two.brains[`${id}-${net.id}`]!.weights[biasRow]).toEqual({ [`${id}-${wheel}`]: -7 })
  })

  it('with the same program has weights of its own, to begin with the same', () => {
    const { id, document: two } = withRobot(document, 'bo', 'shared')
    expect(two.world.robots.map((robot) => [robot.id, robot.program, robot.brain])).toEqual([
      ['bo', 'main', ''],
      [id, 'main', id],
    ])
    expect(two.brains[net.id]!.sets[id]).toEqual(document.brains[net.id]!.weights)
    expect(isProject(two).world.robots).toHaveLength(2)
  })

  it('with a program of its own shares no block and no network', () => {
    const { id, document: two } = withRobot(document, 'bo', 'own')
    const own = netOf(two.programs[id]!)
    expect(own.id).not.toBe(net.id)
    const [from, to] = [own.inputs[0]!.id, own.outputs[0]!.id]
    expect(two.brains[own.id]!.weights[from]?.[to]).toBe(document.brains[net.id]!.weights[eye]?.[wheel])
    expect(brainsFor(two.programs, two.brains)[own.id]).toEqual(two.brains[own.id])
    expect(isProject(two).programs).toHaveProperty(id)
  })

  it('is copied from copies, and from blocks with the longest ids, without ids that no file may have', () => {
    let one: Document = document
    for (const robot of ['bo', 'bo2', 'bo3']) one = withRobot(one, robot, 'own').document
    const ids = Object.values(one.programs).map((program) => netOf(program).id)
    expect(ids).toEqual([net.id, `bo2-${net.id}`, `bo3-${net.id}`, `bo4-${net.id}`])
    expect(isProject(one).world.robots).toHaveLength(4)

    const long = JSON.parse(
      JSON.stringify(solution)
        .replaceAll('"eye', `"${'e'.repeat(190)}`)
        .replaceAll(`"${net.id}"`, `"${'n'.repeat(200)}"`),
    ) as typeof solution
    let grown: Document = { ...long, world, brains: brainsFor(long.programs, long.brains) }
    for (const robot of ['bo', 'bo2']) grown = withRobot(grown, robot, 'own').document
    expect(isProject(grown).world.robots).toHaveLength(3)
    const [first, , third] = Object.values(grown.programs).map((program) => grown.brains[netOf(program).id]!)
    expect(Object.values(third!.weights).flatMap((row) => Object.values(row))).toEqual(
      Object.values(first!.weights).flatMap((row) => Object.values(row)),
    )
  })

  it.each(['shared', 'own'] as const)('drives by its own weights (%s)', (kind) => {
    const { id, document: two } = withRobot(document, 'bo', kind)
    const lab = createLab()
    lab.load(two, paintFloor(world), { seed: 1, checks: [] })
    const own = netOf(two.programs[two.world.robots[1]!.program]!)
    const set = kind === 'shared' ? id : ''
    for (const { id: from } of own.inputs)
      for (const { id: to } of own.outputs) lab.setWeight(own.id, from, to, 0, set)
    lab.start()
    lab.advance(60)
    const [bo, other] = lab.view().robots
    expect(other!.motors).toMatchObject({ B: 0, C: 0 })
    expect(bo!.motors['B']).not.toBe(0)
  })

  it('with a program of its own takes along what that has learned by trying, and takes it away again', () => {
    const tried = content.program('try-dodge', 'solution')!
    const one: Document = { ...tried, world }
    const { id, document: two } = withRobot(one, 'bo', 'own')
    expect(two.tables).toEqual({ try: tried.tables!['try'], [`${id}-try`]: tried.tables!['try'] })
    expect(withoutRobot(two, id)).toEqual(one)
    expect(withoutRobot(two, 'bo').tables).toEqual({ [`${id}-try`]: tried.tables!['try'] })
  })

  it('is gone without a trace when it is taken away', () => {
    for (const kind of ['shared', 'own'] as const) {
      const { id, document: two } = withRobot(document, 'bo', kind)
      expect(withoutRobot(two, id)).toEqual(document)
    }
  })

  it('has a name of its own, whatever is there', () => {
    let grown = document
    for (let more = 0; more < 3; more++)
      grown = withRobot(grown, 'bo', more === 1 ? 'own' : 'shared').document
    expect(grown.world.robots.map(({ id }) => id)).toEqual(['bo', 'bo2', 'bo3', 'bo4'])
    expect(withRobot(withoutRobot(grown, 'bo3'), 'bo', 'shared').id).toBe('bo3')
  })

  it('leaves the others their weights when one of a set is changed', () => {
    const { id, document: two } = withRobot(document, 'bo', 'shared')
    const brain = withWeight(two.brains[net.id]!, eye, wheel, 0.123, id)
    expect(brain.weights).toEqual(document.brains[net.id]!.weights)
    expect(brain.sets[id]![eye]![wheel]).toBe(0.123)
  })

  it('the last one stays', () => {
    expect(withoutRobot(document, 'bo')).toBe(document)
  })
})
