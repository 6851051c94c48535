/** What is used of an EventSource: a stream of events that a server sends. */
export interface Source {
  /** 2: closed. It is not opened again by itself then. */
  readonly readyState: number
  addEventListener(name: string, hear: (event: { readonly data: string }) => void): void
  close(): void
}
