import { follows, test } from '../gate.ts'
import { goesThrough } from '../steps.ts'

test.use({ language: 'en' })

test('about Botgarten, step by step', { tag: '@about' }, async ({ child, page }) => {
  await goesThrough(
    child,
    'about',
    {
      'about Botgarten': () => follows(child, 'parts.about'),
      'who runs it': async () => {
        await page.route('**/operator.md', (route) =>
          route.fulfill({ contentType: 'text/markdown', body: 'The school at the **lake**.' }),
        )
        await page.reload()
        await child.seesTitle()
      },
    },
    { hides: /(?<=Version )[\d.]+/g },
  )
})
