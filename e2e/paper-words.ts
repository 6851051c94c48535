/**
 * Words on each paper of a page that are smaller than is asked for it, in pt; at the foot of a page they may be as small as
 * rules for paper let them. What is drawn (blocks, nets, maps) is measured by tests of its own. Runs in the page.
 */
export function smallWords(least: readonly number[]): string[][] {
  const atFoot = 8.5
  const zoomOf = (element: Element) => (element as Element & { currentCSSZoom: number }).currentCSSZoom
  const ptOf = (element: Element) =>
    (parseFloat(getComputedStyle(element).fontSize) * zoomOf(element) * 72) / 96
  const isRead = (element: Element) =>
    element.closest('.for-ears-only, figure, svg, [role=img]') === null &&
    element.getBoundingClientRect().height > 0
  function wordsIn(paper: Element): readonly (readonly [Element, string])[] {
    const texts = document.createTreeWalker(paper, NodeFilter.SHOW_TEXT)
    const found: [Element, string][] = []
    for (let node = texts.nextNode(); node; node = texts.nextNode()) {
      const element = node.parentElement!
      const text = node.textContent!.trim()
      if (/[\p{L}\d]/u.test(text) && isRead(element)) found.push([element, text])
    }
    return found
  }
  return [...document.querySelectorAll('.pack > .paper')].map((paper, at) => {
    const sizes = wordsIn(paper).map(([element, text]) => {
      const must = element.closest('footer') ? Math.min(atFoot, least[at]!) : least[at]!
      return { text: text.slice(0, 40), pt: ptOf(element), must }
    })
    const small = sizes.filter(({ pt, must }) => pt < must - 0.05)
    return small.map(({ text, pt, must }) => `“${text}” has ${pt.toFixed(1)} pt, not ${must}`)
  })
}

/** How small the smallest words of a plan are, in pt, and what of it is made smaller or cut, by the place of its paper. */
export function smallInPlans(): {
  readonly [at: number]: { readonly least: number; readonly wrong: string[] }
} {
  function smallIn(plan: Element) {
    const words = [...plan.querySelectorAll<HTMLElement>('.plan-page .body :is(p, li, td, th, h1, h2, h3)')]
    return {
      least: Math.min(...words.map((one) => (parseFloat(getComputedStyle(one).fontSize) * 72) / 96)),
      wrong: [...plan.querySelectorAll<HTMLElement>('.plan-page')].flatMap((page, at) => {
        const { zoom } = page.querySelector<HTMLElement>('.body')!.dataset
        return [
          ...(zoom === '1.00' ? [] : [`page ${at + 1} is made smaller: ${zoom}`]),
          ...(page.scrollHeight > page.clientHeight + 1 ? [`page ${at + 1} is cut`] : []),
        ]
      }),
    }
  }
  const papers = [...document.querySelectorAll('.pack > .paper')]
  return Object.fromEntries(
    papers.flatMap((paper, at) => (paper.querySelector('.plan-page') ? [[at, smallIn(paper)]] : [])),
  )
}
