/** What prints by script waits for `html[data-print=ready]`: every picture is drawn, every font is there. */
export function printReady(paper: HTMLElement): () => void {
  const isReady = () =>
    paper.querySelector('[aria-busy=true], .waits') === null &&
    [...paper.querySelectorAll('img')].every(({ complete }) => complete)
  const look = () => {
    if (!isReady()) return
    void document.fonts.ready.then(() => (document.documentElement.dataset['print'] = 'ready'))
  }
  const observer = new MutationObserver(look)
  observer.observe(paper, { attributes: true, childList: true, subtree: true })
  paper.addEventListener('load', look, true)
  look()
  return () => {
    observer.disconnect()
    paper.removeEventListener('load', look, true)
    delete document.documentElement.dataset['print']
  }
}
