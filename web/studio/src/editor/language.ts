// YAML as the editor colours it. The parser recurses, so a text nested thousands deep can run out of stack in it; such a text
// stays without colours, and the core says what is wrong with it.
import { yamlLanguage } from "@codemirror/lang-yaml";
import { Language, LanguageSupport } from "@codemirror/language";
import { NodeType, Parser, Tree } from "@lezer/common";
import type { Input, PartialParse, TreeFragment } from "@lezer/common";

class Guarded implements PartialParse {
  private isLost = false;

  constructor(private parse: PartialParse, private length: number) {}

  get parsedPos(): number { return this.isLost ? this.length : this.parse.parsedPos; }
  get stoppedAt(): number | null { return this.parse.stoppedAt; }
  stopAt(at: number): void { this.parse.stopAt(at); }

  advance(): Tree | null {
    try {
      return this.parse.advance();
    } catch (error) {
      if (!(error instanceof RangeError)) throw error;
      this.isLost = true;
      return new Tree(NodeType.none, [], [], this.parse.stoppedAt ?? this.length);
    }
  }
}

class GuardedParser extends Parser {
  createParse(input: Input, fragments: readonly TreeFragment[], ranges: readonly { from: number; to: number }[]): PartialParse {
    return new Guarded(yamlLanguage.parser.createParse(input, fragments, ranges), input.length);
  }
}

export const yaml = (): LanguageSupport => new LanguageSupport(new Language(yamlLanguage.data, new GuardedParser(), [], "yaml"));
