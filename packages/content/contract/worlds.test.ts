import { existsSync } from 'node:fs'
import { COLOURS, createSimulation, type Colour } from '@botgarten/simulation'
import { completeLanguages } from '@botgarten/messages/folder'
import { describe, expect, it } from 'vitest'
import { content } from '../files.ts'
import { wordsIn } from './there.ts'

// Every world is held to the same rules merely because it is there.
describe.each(content.worlds)('the world %s', (id) => {
  const world = content.world(id)!

  it('has a floor that is there and can be read', () => {
    const floor = content.floorOf(world)
    expect(floor.width / floor.height).toBeCloseTo(world.size.width / world.size.height, 3)
  })

  it('has its things on the floor and ids that name one thing each', () => {
    const things = [...world.obstacles, ...world.robots]
    expect(new Set(things.map(({ id }) => id)).size).toBe(things.length)
    for (const { pose } of things) {
      expect(pose.x > 0 && pose.x < world.size.width && pose.y > 0 && pose.y < world.size.height).toBe(true)
    }
  })

  it('keeps the drawing from which its floor was made', () => {
    expect(existsSync(content.path('worlds', id, 'floor.svg'))).toBe('asset' in world.floor)
  })

  it.each(completeLanguages)('has a name in "%s"', (language) => {
    expect(wordsIn(language, 'worldName')[id]).toMatch(/\S/)
  })
})

function worldOf(id: string) {
  const world = content.world(id)!
  return { world, simulation: createSimulation(world, content.floorOf(world), 1) }
}

/** What the sensor names when the robot is put on points 10 cm apart. */
function coloursOn(id: string): (Colour | null)[] {
  const { world, simulation } = worldOf(id)
  const seen: (Colour | null)[] = []
  for (let y = 20; y <= world.size.height - 20; y += 10)
    for (let x = 20; x <= world.size.width - 20; x += 10) {
      simulation.place('bo', { x, y, heading: 0 })
      seen.push(simulation.read(0, '1', 'colour') as Colour | null)
    }
  return seen
}

const { red, yellow, green, blue, brown, black, grey, white } = COLOURS

describe('the worlds as sensors see them', () => {
  it.each([
    ['blank', [white]],
    ['line', [white, black]],
    ['colours', [red, yellow, green, blue, brown, black, grey, white]],
    ['rally', [red, blue, grey, white]],
    ['chameleon', [red, yellow, green, white]],
  ])('%s has these colours and no other', (id, colours) => {
    // On an edge the sensor sees two colours mixed: fewer than one point in twenty.
    const points = coloursOn(id)
    const seen = colours.map((colour) => points.filter((point) => point === colour).length)
    expect(Math.min(...seen) / points.length).toBeGreaterThan(0.01)
    expect(seen.reduce((all, one) => all + one) / points.length).toBeGreaterThan(0.95)
  })

  it('line: the robot begins on it', () => {
    const { world, simulation } = worldOf('line')
    simulation.place('bo', world.robots[0]!.pose)
    expect(simulation.read(0, '1', 'colour')).toBe(black)
  })

  it('maze: a robot with room to turn finds its way from the start to the green field', () => {
    const { world } = worldOf('maze')
    const turning = 16
    const free = (x: number, y: number) =>
      world.obstacles.every(({ shape, pose }) => {
        if (shape.kind !== 'rectangle') return false
        const aside = Math.max(0, Math.abs(x - pose.x) - shape.width / 2)
        const over = Math.max(0, Math.abs(y - pose.y) - shape.height / 2)
        return aside * aside + over * over > turning * turning
      })
    const start = world.robots[0]!.pose
    const seen = new Set<string>()
    const ways = [[start.x, start.y] as const]
    for (const [x, y] of ways) {
      const inside =
        x >= turning && y >= turning && x <= world.size.width - turning && y <= world.size.height - turning
      if (seen.has(`${x} ${y}`) || !inside || !free(x, y)) continue
      seen.add(`${x} ${y}`)
      ways.push([x + 2, y], [x - 2, y], [x, y + 2], [x, y - 2])
    }
    expect(seen.has('330 210')).toBe(true)
    expect(ways.length).toBeLessThan(40_000)
  })
})
