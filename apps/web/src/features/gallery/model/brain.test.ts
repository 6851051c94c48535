import { content } from '@botgarten/content/files'
import { cardProject } from '@botgarten/content/document'
import { weightsOf } from '@botgarten/learning/neural-network'
import { parseProject, type Project } from '@botgarten/programs'
import { describe, expect, it } from 'vitest'
import { brainOf, fitted, withBrain } from './brain.ts'

function projectOf(id: string, program: 'start' | 'solution'): Project {
  const { card, world } = content.card(id)!
  return cardProject(world, card, content.program(id, program)!, id)
}
const [mine, theirs] = [projectOf('friendship', 'start'), projectOf('friendship', 'solution')]

describe('the brain of something shared', () => {
  it('goes onto the own knobs, and what was on them stays among the saved brains', () => {
    const own = brainOf(mine)!
    const given = brainOf(theirs)!
    const fit = fitted(given, own)!
    const after = parseProject(JSON.stringify(withBrain(mine, own, fit, 'before')))
    const brain = after.brains[own.net.id]!
    expect(brain.weights).toEqual({ eyeLeft: { wheelLeft: 0.8 }, eyeRight: { wheelRight: 0.8 } })
    expect(weightsOf(brain, 'before')).toEqual(own.weights)
    expect(after.programs).toEqual(mine.programs)
    expect(after.world).toEqual(mine.world)
  })

  it('has a name even if the brain before it has none, and never a name that is in use', () => {
    const taken = (project: Project) => {
      const own = brainOf(project)!
      return withBrain(project, own, fitted(brainOf(theirs)!, own)!, ' ')
    }
    const { net } = brainOf(mine)!
    expect(Object.keys(taken(taken(mine)).brains[net.id]!.sets)).toEqual(['brain', 'brain 2'])
  })

  it('fits alike with the same sensors; a sensor at another port and one that stands elsewhere are named', () => {
    expect(fitted(brainOf(theirs)!, brainOf(mine)!)!.differences).toEqual([])
    const swapped = JSON.parse(
      JSON.stringify(mine)
        .replaceAll('"ULTRASONIC_PORT_2"', '"ULTRASONIC_PORT_4"')
        .replaceAll('"SENSORPORT":"2"', '"SENSORPORT":"4"'),
    ) as Project
    const { differences } = fitted(brainOf(theirs)!, brainOf(swapped)!)!
    expect(differences.filter(({ placeOnly }) => !placeOnly)).toHaveLength(1)

    const robot = mine.world.robots[0]!
    const [port, sensor] = Object.entries(robot.config.sensors).find(([, one]) => one.kind === 'ultrasonic')!
    const sensors = { ...robot.config.sensors, [port]: { ...sensor, x: Number(sensor.x) + 3 } }
    const moved = { ...mine.world, robots: [{ ...robot, config: { ...robot.config, sensors } }] }
    const elsewhere = fitted(brainOf(theirs)!, brainOf({ ...mine, world: moved })!)!
    expect(elsewhere.differences.map(({ placeOnly }) => placeOnly)).toEqual([true])
  })

  it('of other layers does not fit, and a project without a network has none', () => {
    expect(fitted(brainOf(projectOf('chameleon', 'solution'))!, brainOf(mine)!)).toBeNull()
    expect(brainOf({ ...mine, programs: { main: { stacks: [], config: { stacks: [] } } } })).toBeNull()
  })
})
