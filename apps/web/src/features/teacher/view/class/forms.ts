import type { Component } from 'svelte'

/** What shows the questionnaires of a class. `ask`: of the class server, below the class. */
type ClassForms = Component<{
  ask: (method: 'GET' | 'POST' | 'DELETE', path: string, body?: unknown) => Promise<unknown>
}>
export type LoadForms = () => Promise<ClassForms>
