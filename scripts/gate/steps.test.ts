import { expect, test } from 'vitest'
import { listSteps, stepsOf } from './steps.mjs'

const steps = ['home', 'sorting', 'teacher', 'teacher-account'].map((name) => ({
  file: `e2e/steps/${name}.spec.ts`,
  features: [name.replace('-account', '')],
}))
const namesOf = (...changed: readonly string[]) =>
  stepsOf(changed, steps).map((file) => file.replace(/^e2e\/steps\/|\.spec\.ts$/g, ''))

test('all steps of a changed feature run, and changed steps', () => {
  expect(namesOf('apps/web/src/features/teacher/view/Live.svelte')).toEqual(['teacher', 'teacher-account'])
  expect(namesOf('e2e/steps/home.spec.ts', 'content/words/en/teacher.json')).toEqual(['home'])
  expect(namesOf()).toEqual([])
})

test('every file with steps names its features', () => {
  for (const { features } of listSteps()) expect(features.length).toBeGreaterThan(0)
})
