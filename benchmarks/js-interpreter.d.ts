/** What we use of it. */
declare module 'js-interpreter' {
  export default class JSInterpreter {
    constructor(code: string)
    readonly value: unknown
    /** Runs to the end; true where the program waits. */
    run(): boolean
  }
}
