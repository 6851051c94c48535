import 'fake-indexeddb/auto'
import { addBlocks } from '@botgarten/blocks'
import { learning } from '@botgarten/blocks/packs/learning'
import { cardProject } from '@botgarten/content'
import { content } from '@botgarten/content/files'
import { tryingIn, type Project } from '@botgarten/programs'
import { afterEach, beforeAll, beforeEach, describe, expect, test, vi } from 'vitest'
import { closeSessions, sessionOf } from '#lab/testing/session.ts'
import { freshLocalStorage } from '#storage/testing/local.ts'
import { fetchWords } from '#words/message.ts'
import { Code } from './code.svelte.ts'
import { guideOf } from './model/guide.ts'

beforeAll(async () => {
  addBlocks(learning)
  await fetchWords('python', 'expert')
})
beforeEach(() => void freshLocalStorage())
afterEach(() => {
  closeSessions()
  vi.unstubAllGlobals()
})

function solved(card: string): Project {
  const loaded = content.card(card)!
  return cardProject(loaded.world, loaded.card, content.program(card, 'solution')!, card)
}

function codeOf(project: Project = solved('friendship'), title = 'My robot') {
  const { session } = sessionOf(project, { isCard: false })
  return { session, code: new Code(session, () => title) }
}

describe('the program as Python', () => {
  test('follows every change of the weights', () => {
    const { session, code } = codeOf()
    const before = code.file.text
    session.weights.turn('net', 'eyeLeft', 'wheelRight', 0.123, 'whole')
    expect(code.file.text).not.toBe(before)
    expect(code.file.text).toContain('0.123')
  })

  test('has a file for each robot: its dialect is chosen, and stays chosen on this device', () => {
    const { session, code } = codeOf()
    expect([code.dialect, /^from pybricks/m.test(code.file.text)]).toEqual(['pybricks', true])
    code.dialect = 'ev3dev2'
    expect(code.file.text).toMatch(/^from ev3dev2/m)
    expect(new Code(session, () => '').dialect).toBe('ev3dev2')
    expect(code.name).toMatch(/^my_robot\w*\.py$/)
  })

  test('of a robot without a program names the missing program', () => {
    const { code } = codeOf({ ...solved('friendship'), programs: {} })
    expect(code.file.notes).toMatchObject([{ block: '', gap: true }])
    expect(code.unfinished).toBe(true)
  })
})

describe('a gap in the program', () => {
  const { card, world } = content.card('friendship')!
  const withGap = (): Project => {
    const project = cardProject(world, card, content.program('friendship', 'solution')!, 'friendship')
    const [stack] = project.programs['main']!.stacks
    const gap = { id: 'gap', type: 'robControls_if' }
    const main = {
      ...project.programs['main']!,
      stacks: [{ ...stack!, blocks: [...stack!.blocks.slice(0, 1), gap] }],
    }
    return { ...project, programs: { main } }
  }

  test('raises an error or is a comment, as is chosen', () => {
    const { session, code } = codeOf(withGap())
    expect([code.unfinished, code.gaps]).toEqual([true, true])
    const raising = code.file.text
    code.gaps = false
    expect([code.file.text === raising, code.unfinished]).toEqual([false, true])
    expect(new Code(session, () => '').gaps).toBe(false)
  })

  test('is not what the robot lacks: that is shown at its blocks', () => {
    const { code } = codeOf(withGap())
    expect(code.missing).toEqual([])
    const told = code.file.notes.map(({ block, gap }) => [block, gap])
    expect(told).toContainEqual(['gap', true])
  })

  test('leaves a program unfinished that also has blocks which the robot cannot obey', () => {
    const project = solved('mars')
    const main = project.programs['main']!
    const [stack, ...others] = main.stacks
    const blocks = [...stack!.blocks, { id: 'gap', type: 'robControls_if' }]
    const { code } = codeOf({
      ...project,
      programs: { main: { ...main, stacks: [{ ...stack!, blocks }, ...others] } },
    })
    expect(code.missing).not.toEqual([])
    expect(code.unfinished).toBe(true)
  })
})

test('a block that the robot of the file cannot obey has a mark of the robot, which stops no run', () => {
  const { code } = codeOf(solved('mars'))
  expect(code.missing).toMatchObject([
    { block: 'draw', problem: 'python.atBlock', mark: 'robot', stops: false },
  ])
  expect(code.missing[0]!.facts!['what']).not.toBe('')
})

describe('lines', () => {
  test('belong to their blocks; those above the program do not run', () => {
    const { code } = codeOf()
    const lines = code.linesOf('net')
    expect(lines.length).toBeGreaterThan(0)
    expect(code.runningLines('net')).toEqual(lines.filter((line) => line >= code.file.head))
    expect([code.linesOf(null), code.runningLines('nothing')]).toEqual([[], []])
  })
})

describe('what was learned by trying', () => {
  test('can go on being learned where the program tries for some minutes', () => {
    const { code } = codeOf(solved('try-dodge'))
    expect(tryingIn(solved('try-dodge').programs['main']!)!.minutes).toBeGreaterThan(0)
    expect([code.canLearn, code.learner]).toEqual([true, false])
    const before = code.file.text
    code.learner = true
    expect(code.file.text).not.toBe(before)
    expect(codeOf().code).toMatchObject({ canLearn: false, learner: true })
  })

  test('is nothing where nothing is learned', async () => {
    const { code } = codeOf()
    const before = code.file.text
    await code.learn()
    expect(code.file.text).toBe(before)
  })
})

test('every robot has its guide among the materials', () => {
  const guides = (['pybricks', 'ev3dev2', 'spike'] as const).map(guideOf)
  expect(new Set(guides).size).toBe(3)
  for (const id of guides) expect(content.items.map((item) => item.id)).toContain(id)
})
