import { leftEye, leftWheel } from '../child.ts'
import { StudyHands } from '../child-study.ts'
import { expect, follows, test } from './gate.ts'

test.use({ language: 'de' })

test(
  'a study locks what it does not hold, writes down a child that agrees, and ends with its log',
  {
    tag: ['@study', '@/study'],
  },
  async ({ child, page }) => {
    const hands = new StudyHands(child)
    await follows(child, 'home.materials')
    await page.getByRole('link', { name: child.word('materials.study') }).click()
    await hands.opens()
    await expect(child.button('study.handOut')).toHaveAttribute('aria-disabled', 'true')
    await page.getByLabel(child.word('study.consentBox')).check()
    await child.presses('study.handOut')
    await hands.begins(1, 2)
    await page.goto('/lab/fear')
    await expect(page).toHaveURL(/\/study$/)
    await hands.opensCard('friendship')
    await expect(child.words('study.writes')).toBeVisible()
    await child.typesWeight(leftEye, leftWheel, 0.8)
    await child.pressesStart()
    await child.seesDriving()
    await child.presses('study.rest')
    await expect(child.words('study.rests')).toBeVisible()
    await child.pressesStop()
    await child.presses('study.wake')
    await expect(child.words('study.writes')).toBeVisible()
    await hands.ends()
    await hands.saysWord()
    const { text } = await hands.takesLogs()
    const events = text.split('\n').flatMap((line) => /"event":"(\w+)"/.exec(line)?.[1] ?? [])
    expect(events).toContain('rest')
    expect(events.at(-1)).toBe('over')
    expect(text).toContain('0102X')
    await child.presses('study.endStudy')
    await page
      .getByRole('dialog')
      .getByRole('button', { name: child.word('study.endStudy') })
      .click()
    await child.opensHome()
  },
)
