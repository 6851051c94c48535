import { cardProject } from '@botgarten/content'
import { content } from '@botgarten/content/files'
import { TryHands } from '../child-trying.ts'
import { expect, opensProject, test } from './gate.ts'

test.use({ language: 'de' })

test(
  'a table fills while Bo tries with its sensors, its number is proved, and time leads back to the empty table',
  {
    tag: '@senses',
  },
  async ({ child }) => {
    const bo = new TryHands(child)
    const { card, world } = content.card('try-dodge')!
    const { programs, brains } = content.program('try-dodge', 'solution')!
    const project = cardProject(world, card, { programs, brains }, 'Versuch')
    await opensProject(child, 'Versuch', JSON.stringify(project))
    await bo.sees()
    // Three distances of each of two eyes, and the bumper, by three actions.
    await expect.poll(() => bo.untried()).toBe(30)
    await child.pressesStart()
    await bo.time.opens()
    await bo.time.chooses('16')
    await bo.time.runsUntil(20)
    const numbers = await bo.numbers()
    const tried = numbers.findIndex((text) => text.trim() !== '·')
    expect(tried).toBeGreaterThanOrEqual(0)
    await bo.cell(Math.floor(tried / 3), tried % 3).click()
    await bo.proof.asks()
    const { number } = await bo.proof.saves()
    expect(number.toFixed(1)).toBe(numbers[tried]!.replace('−', '-').replace(',', '.'))
    await bo.proof.closes()
    await bo.time.goesBack('Home')
    await expect.poll(() => bo.untried()).toBe(30)
    await child.presses('time.toNow')
    await expect.poll(() => bo.numbers()).toEqual(numbers)
    await child.presses('senses.edges')
    await bo.typedEdge('left', 'nearBelow').fill('22')
    await child.types('Enter')
    await expect(bo.edgeOnRay('left', 'nearBelow')).toHaveAttribute('aria-valuenow', '22')
  },
)
