// Rooms: network, editor
// Faults that appeared only in a lab entered from the home page, while tests opened it by its address.
import { NetHands } from '../child-network.ts'
import { expect, test } from '../house.ts'
import { languagesOf } from '../words.ts'

for (const language of languagesOf(import.meta.filename))
  test.describe(`entered from home in ${language}`, () => {
    test.use({ language })

    test('a setting of the network is chosen by its words, as card 13 asks for', async ({ child }) => {
      const net = new NetHands(child)
      await child.opensLab('either-or')
      await net.opensSettings()
      for (const level of ['explorer', 'expert'] as const) {
        await child.words(`net.levels.${level}`).click()
        await expect(net.level(level)).toBeChecked()
      }
    })

    test('no element but the focused one has its ring, and fields of blocks have no second ground', async ({
      child,
    }) => {
      await child.opensHome()
      await (await child.findsCard('loud-distance')).press('Enter')
      await child.seesLab()
      const ringed = await child.page.locator('main *').evaluateAll(
        (all) =>
          all.filter((one) => {
            const ring = getComputedStyle(one).getPropertyValue('--ring').trim()
            return !one.matches(':focus-visible') && !/^(|0 0 transparent|0 0 0 4px.*)$/.test(ring)
          }).length,
      )
      expect(ringed).toBe(0)
      const grounds = await child.page
        .locator('.editor-reach')
        .evaluateAll((all) => all.map((one) => getComputedStyle(one).fill))
      expect(grounds.length).toBeGreaterThan(0)
      expect(new Set(grounds)).toEqual(new Set(['rgba(0, 0, 0, 0)']))
    })
  })
