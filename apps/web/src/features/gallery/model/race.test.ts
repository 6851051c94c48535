import { addBlocks } from '@botgarten/blocks'
import { learning } from '@botgarten/blocks/packs/learning'
import { content } from '@botgarten/content/files'
import { cardProject } from '@botgarten/content/document'
import { createLab } from '@botgarten/lab'
import { parseProject, tryingIn, type Project } from '@botgarten/programs'
import { paintFloor } from '@botgarten/simulation'
import { beforeAll, describe, expect, it } from 'vitest'
import { besideMine } from './race.ts'

beforeAll(() => addBlocks(learning))

function projectOf(id: string, program: 'start' | 'solution'): Project {
  const { card, world } = content.card(id)!
  return cardProject(world, card, content.program(id, program)!, id)
}
const mine = projectOf('friendship', 'start')
const robotsOf = ({ world }: Project) => world.robots
const parsed = (project: Project | null) => parseProject(JSON.stringify(project))

describe('a race beside mine', () => {
  it('a brain that fits drives the own program with weights of its own, under its title', () => {
    const both = parsed(besideMine(mine, projectOf('friendship', 'solution'), 'Rally, fast one'))
    expect(robotsOf(both).map(({ program, brain }) => [program, brain])).toEqual([
      ['main', ''],
      ['main', 'Rally, fast one'],
    ])
    expect(both.brains['net']!.weights).toEqual(mine.brains['net']!.weights)
    expect(both.brains['net']!.sets['Rally, fast one']).toEqual({
      eyeLeft: { wheelLeft: 0.8 },
      eyeRight: { wheelRight: 0.8 },
    })
  })

  it('another kind of robot brings its program, and both drive', () => {
    const both = parsed(
      besideMine(projectOf('friendship', 'solution'), projectOf('chameleon', 'solution'), 'x'),
    )
    const [own, guest] = robotsOf(both)
    expect(guest!.program).not.toBe(own!.program)
    expect(guest!.config).toEqual(robotsOf(projectOf('chameleon', 'solution'))[0]!.config)
    const lab = createLab()
    lab.load(both, paintFloor({ ...both.world, floor: { colour: '#FFFFFF' } }), { seed: 1, checks: [] })
    const before = lab.view().robots.map(({ pose }) => pose)
    lab.start()
    lab.advance(240)
    lab.view().robots.forEach(({ pose, problem }, at) => {
      expect(problem).toBeNull()
      expect(pose).not.toEqual(before[at])
    })
  })

  it('a robot that has learned by trying brings its table along, and drives by it', () => {
    const theirs = projectOf('try-dodge', 'solution')
    const both = parsed(besideMine(projectOf('chameleon', 'solution'), theirs, 'x'))
    const [[id, table] = []] = Object.entries(both.tables ?? {})
    expect(table).toEqual(theirs.tables!['try'])
    const guest = both.programs[robotsOf(both)[1]!.program]!
    expect(tryingIn(guest)!.id).toBe(id)
    const lab = createLab()
    lab.load(both, paintFloor({ ...both.world, floor: { colour: '#FFFFFF' } }), { seed: 1, checks: [] })
    lab.start()
    lab.advance(60)
    expect(lab.state().trials[1]!.learning).toBeNull()
    expect(lab.view().robots[1]!.problem).toBeNull()
  })

  it('a title is the name of its weights up to forty letters', () => {
    const nameFor = (title: string) =>
      robotsOf(besideMine(mine, projectOf('friendship', 'solution'), title)!)[1]!.brain
    expect([nameFor('x'.repeat(40)), nameFor('x'.repeat(41))]).toEqual([
      'x'.repeat(40),
      expect.stringMatching(/^bo/),
    ])
  })

  it('a title that no weight set may have is not its name', () => {
    for (const title of ['__proto__', 'bo', 'x'.repeat(60)]) {
      const both = parsed(besideMine(mine, projectOf('friendship', 'solution'), title))
      expect(robotsOf(both)[1]!.brain).toMatch(/^bo\d$/)
    }
  })

  it('is refused where four robots are there', () => {
    let full: Project = mine
    for (let at = 0; at < 3; at++) full = besideMine(full, mine, `robot ${at}`)!
    expect(robotsOf(full)).toHaveLength(4)
    expect(besideMine(full, mine, 'one more')).toBeNull()
  })
})
