import type { Document } from '@botgarten/lab'
import { networks, parseProject, type Project } from '@botgarten/programs'
import { readCard, type CardProgram } from '@botgarten/content'
import type { World } from '@botgarten/simulation'
import { readFileSync } from 'node:fs'
import { describe, expect, it } from 'vitest'
import { withBeside } from './beside.ts'
import { withoutRobot } from '#lab/robots.ts'
import { differing, linksOf, twinsOf, weightIn } from './twins.ts'

const content = new URL('../../../../../content/', import.meta.url)
const read = (path: string) => JSON.parse(readFileSync(new URL(path, content), 'utf8')) as unknown
const card = readCard(read('cards/network/06-fear/card.json'))
const program = read('cards/network/06-fear/solution.json') as CardProgram
const world = read('worlds/fear/world.json') as World
const document: Document = { ...program, world }
const outlines = networks(program.programs['main']!)
const { id, document: two } = withBeside(document, card.beside!, 'Friendship')
const session = (robotId: string, shown: Document = two) => ({
  robotId,
  outlines,
  lab: { document: shown, facts: { brains: shown.brains } },
})

describe('Fear and Friendship side by side', () => {
  it('are two robots of one program, each with its own weights', () => {
    expect(Object.keys(two.programs)).toEqual(['main'])
    expect(two.world.robots.map((robot) => [robot.program, robot.brain])).toEqual([
      ['main', ''],
      ['main', 'Friendship'],
    ])
    expect(two.brains['net']!.weights).toEqual(document.brains['net']!.weights)
    const project: Project = { botgarten: 1, name: 'two', ...two, assets: {} }
    expect(parseProject(JSON.parse(JSON.stringify(project))).brains['net']!.sets).toHaveProperty('Friendship')
  })

  it('differ on every link, for whoever is chosen', () => {
    for (const robot of ['bo', id]) {
      const { own, twins } = twinsOf(session(robot))
      expect(twins).toHaveLength(1)
      expect(linksOf({ outlines }).map((link) => differing(own, twins, link).length)).toEqual([1, 1, 1, 1])
    }
  })

  it('differ no more where the weights are the same; a 0 and nothing written are the same', () => {
    const set = { eyeLeft: { wheelLeft: 0, wheelRight: 0.8 }, eyeRight: { wheelLeft: 0.8 } }
    const { document: same } = withBeside(document, { ...card.beside!, weights: { net: set } }, 'Fear')
    const { own, twins } = twinsOf(session('bo', same))
    expect(linksOf({ outlines }).filter((link) => differing(own, twins, link).length > 0)).toEqual([])
  })

  it('are no twins without a network, or where nobody is chosen', () => {
    const none = { own: {}, twins: [] }
    expect(twinsOf({ ...session('bo'), outlines: [] })).toEqual(none)
    expect(twinsOf(session('nobody'))).toEqual(none)
    expect(linksOf({ outlines: [] })).toEqual([])
  })

  it('never takes the name of a set that is there, and goes without a trace', () => {
    const first = withoutRobot(two, id)
    expect(first).toEqual(document)
    const named = { ...document, brains: { net: { ...document.brains['net']!, sets: { Friendship: {} } } } }
    const { document: both } = withBeside(named, card.beside!, 'Friendship')
    expect(both.brains['net']!.sets['Friendship']).toEqual({})
    expect(both.world.robots[1]!.brain).toBe('bo2')
  })

  it('have the weight 0 on a link that has none', () => {
    const weights = { eyeLeft: { wheelLeft: 0.5 } }
    expect(weightIn(weights, { from: 'eyeLeft', to: 'wheelLeft' })).toBe(0.5)
    expect(weightIn(weights, { from: 'eyeLeft', to: 'wheelRight' })).toBe(0)
    expect(weightIn(weights, { from: 'eyeRight', to: 'wheelLeft' })).toBe(0)
  })
})
