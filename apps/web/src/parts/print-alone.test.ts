import { expect, test } from 'vitest'
import { printAlone } from './print-alone.ts'

/** The properties of an element that the attachment uses. */
const element = (parentElement: HTMLElement | null) => ({ dataset: {}, parentElement }) as HTMLElement

test('an element is marked, and so are its ancestors as long as it is on the page', () => {
  const page = element(null)
  const dialog = element(page)
  const sheet = element(dialog)
  const release = printAlone(sheet)
  expect([page, dialog, sheet].map(({ dataset }) => Object.keys(dataset))).toEqual([
    ['printHolds'],
    ['printHolds'],
    ['printAlone'],
  ])
  release()
  expect([page, dialog].map(({ dataset }) => Object.keys(dataset))).toEqual([[], []])
})
