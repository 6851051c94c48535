import { sixRows, Teaching, weightsOfSixRows } from '../child-training.ts'
import { ProofHands } from '../child-proof.ts'
import { expect, opensCard, test } from './gate.ts'

test.use({ language: 'de' })

test(
  'examples are shown and practised: the error falls, the knobs turn, and Bo drives with them',
  {
    tag: '@training',
  },
  async ({ child, page }) => {
    const teaching = new Teaching(child)
    const proof = new ProofHands(child)
    await opensCard(child, 'friendship')
    await teaching.shows()
    await teaching.remembers(45, 45)
    await teaching.seesExamples(1)
    await child.types('Control+z')
    await teaching.seesExamples(0)
    await teaching.opensFile('rows.csv', sixRows)
    await teaching.seesExamples(6)
    await teaching.setsAside(2)
    await teaching.seesExamples(5)
    await child.types('Control+z')
    await teaching.seesExamples(6)

    await teaching.letsPractise()
    await teaching.practises()
    await expect(teaching.curve).toHaveAttribute('aria-valuenow', '60')
    await expect.poll(() => teaching.hashOfWeights()).toBe(weightsOfSixRows)
    const error = async () => {
      await proof.asks()
      const [percent] = (await proof.sum()).match(/[\d,]+(?=\D*$)/)!
      await proof.closes()
      return Number(percent.replace(',', '.'))
    }
    const last = await error()
    await teaching.curve.press('Home')
    await expect(teaching.curve).toHaveAttribute('aria-valuenow', '0')
    expect(await error()).toBeGreaterThan(last)
    await teaching.curve.press('End')
    await expect(teaching.curve).toHaveAttribute('aria-valuenow', '60')

    await child.presses('training.oneExample')
    for (const beat of ['inputs', 'sums', 'says', 'error', 'arrows', 'knobs'])
      await child.presses(`training.next.${beat}`)
    await child.presses('training.close')
    await expect.poll(() => teaching.hashOfWeights()).not.toBe(weightsOfSixRows)
    await child.types('Control+z')
    await expect.poll(() => teaching.hashOfWeights()).toBe(weightsOfSixRows)
    await child.pressesStart()
    await child.seesDriving()
    await expect(page.getByText(child.word('training.drove'))).toBeVisible()
  },
)
