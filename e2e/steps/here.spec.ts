import { expect, test } from '../gate/gate.ts'
import { goesThrough } from '../steps.ts'

test.use({ language: 'en', complaints: [/status of 404/] })

test('the page of the machine that serves, step by step', { tag: '@here' }, async ({ child, page }) => {
  const code = page.getByRole('img', { name: child.word('here.code') })
  /** The page as a server answers; null: to another machine. */
  const opens = async (place: object | null) => {
    await page.unroute('**/here.json')
    await page.route('**/here.json', (route) =>
      place === null ? route.fulfill({ status: 404 }) : route.fulfill({ json: place }),
    )
    // By address: the first start opens this page.
    await page.goto('about:blank')
    await page.goto('/here#a-link-of-the-first-teacher')
    await child.seesTitle()
  }
  const here = { announced: null, folder: null, otherDevice: null }
  await goesThrough(
    child,
    'here',
    {
      'no network': () => opens(here),
      'nobody has come yet': async () => {
        await opens({ ...here, announced: 'http://garden.example:4173', folder: '/home/school/botgarten' })
        await expect(code).toHaveAttribute('viewBox', /\d/)
        await expect(code.locator('path')).toHaveAttribute('d', /M/)
      },
      'another device is connected': () =>
        opens({ ...here, announced: 'http://garden.example:4173', otherDevice: 1 }),
      'another machine': () => opens(null),
    },
    { hides: /(?<=port )\d+/g },
  )
})
